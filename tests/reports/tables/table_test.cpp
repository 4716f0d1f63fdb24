#include "reports/tables/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gibench::report {
namespace {

using testing::HasSubstr;
using testing::Not;

Table awkward_table() {
  return {.name = "awkward",
          .caption = "50% of <b> & c",
          .columns = {{"Name", "name", false}, {"Value", "value", true}},
          .rows = {{{"a|b_c", "a|b_c"}, {"1.0", "1"}}, {{"say \"x\", y\nz", "say \"x\", y\nz"}, {"–", ""}}}};
}

TEST(Escape, Html) { EXPECT_EQ(escape_html("<a b=\"c\">&'</a>"), "&lt;a b=&quot;c&quot;&gt;&amp;&#39;&lt;/a&gt;"); }

TEST(Escape, Latex) {
  EXPECT_EQ(escape_latex("50% & $x_1^2$ {#} ~ \\"),
            "50\\% \\& \\$x\\_1\\textasciicircum{}2\\$ \\{\\#\\} \\textasciitilde{} \\textbackslash{}");
  EXPECT_EQ(escape_latex("≤ 3× – <y>"), "$\\leq$ 3$\\times$ -- \\textless{}y\\textgreater{}");
  // A bracket after a row's end would be taken for its optional argument.
  EXPECT_EQ(escape_latex("[1, 2]"), "{[}1, 2{]}");
}

TEST(Escape, Markdown) { EXPECT_EQ(escape_markdown("a|b*c_d<e>`"), "a\\|b\\*c\\_d&lt;e&gt;\\`"); }

TEST(Escape, ControlCharactersAndLineBreaks) {
  EXPECT_EQ(escape_html(std::string("a\x1b[31m\nb\x00", 9)), "a[31m b");
  EXPECT_EQ(escape_latex("a\nb"), "a b");
}

TEST(Table, Csv) { EXPECT_EQ(to_csv(awkward_table()), "name,value\r\na|b_c,1\r\n\"say \"\"x\"\", y\nz\",\r\n"); }

TEST(Table, MarkdownHasOneLineARow) {
  const std::string text = to_markdown(awkward_table());
  EXPECT_THAT(text, HasSubstr("| Name | Value |\n| --- | ---: |\n| a\\|b\\_c | 1.0 |\n| say \"x\", y z | – |\n"));
  EXPECT_THAT(text, HasSubstr("50% of &lt;b&gt; &amp; c"));
}

TEST(Table, LatexIsBalancedAndEscaped) {
  const std::string text = to_latex(awkward_table());
  EXPECT_THAT(text, HasSubstr("\\caption{50\\% of \\textless{}b\\textgreater{} \\& c}"));
  EXPECT_THAT(text, HasSubstr("\\begin{tabular}{lr}"));
  EXPECT_THAT(text, HasSubstr("    a|b\\_c & 1.0 \\\\\n"));
  EXPECT_THAT(text, HasSubstr("\\end{tabular}\n\\end{table}\n"));
  EXPECT_THAT(text, Not(HasSubstr("z &  \\\\")));
}

}  // namespace
}  // namespace gibench::report
