#include "reports/tables/table.h"

#include <array>
#include <span>
#include <utility>

namespace gibench::report {
namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

/// Each occurrence of a first replaced by its second, in one pass.
std::string replaced(std::string_view text, std::span<const Replacement> replacements) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    bool found = false;
    for (const auto& [from, to] : replacements) {
      if (!text.starts_with(from)) continue;
      out += to;
      text.remove_prefix(from.size());
      found = true;
      break;
    }
    if (found) continue;
    const auto c = static_cast<unsigned char>(text.front());
    if (c >= 0x20) out += text.front();
    else if (c == '\n' || c == '\t') out += ' ';
    text.remove_prefix(1);
  }
  return out;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

template <class Item, class Text>
std::string joined(const std::vector<Item>& items, std::string_view between, Text text) {
  std::string line;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) line += between;
    line += text(items[i]);
  }
  return line;
}

}  // namespace

std::string escape_html(std::string_view text) {
  static constexpr std::array<Replacement, 5> entities{
      {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&#39;"}}};
  return replaced(text, entities);
}

std::string escape_markdown(std::string_view text) {
  static constexpr std::array<Replacement, 11> escapes{{{"\\", "\\\\"},
                                                        {"|", "\\|"},
                                                        {"*", "\\*"},
                                                        {"_", "\\_"},
                                                        {"`", "\\`"},
                                                        {"[", "\\["},
                                                        {"]", "\\]"},
                                                        {"&", "&amp;"},
                                                        {"<", "&lt;"},
                                                        {">", "&gt;"},
                                                        {"#", "\\#"}}};
  return replaced(text, escapes);
}

std::string escape_latex(std::string_view text) {
  static constexpr std::array<Replacement, 21> escapes{{{"\\", "\\textbackslash{}"},
                                                        {"{", "\\{"},
                                                        {"}", "\\}"},
                                                        {"$", "\\$"},
                                                        {"&", "\\&"},
                                                        {"#", "\\#"},
                                                        {"%", "\\%"},
                                                        {"_", "\\_"},
                                                        {"^", "\\textasciicircum{}"},
                                                        {"~", "\\textasciitilde{}"},
                                                        {"<", "\\textless{}"},
                                                        {">", "\\textgreater{}"},
                                                        {"–", "--"},
                                                        {"−", "$-$"},
                                                        {"×", "$\\times$"},
                                                        {"≤", "$\\leq$"},
                                                        {"≥", "$\\geq$"},
                                                        {"²", "$^2$"},
                                                        {"µ", "$\\mu$"},
                                                        {"[", "{[}"},
                                                        {"]", "{]}"}}};
  return replaced(text, escapes);
}

std::string to_csv(const Table& table) {
  std::string out = joined(table.columns, ",", [](const Column& column) { return csv_field(column.name); }) + "\r\n";
  for (const auto& row : table.rows) out += joined(row, ",", [](const Cell& cell) { return csv_field(cell.raw); }) + "\r\n";
  return out;
}

Table shown(Table table) {
  const std::vector<Column> columns = std::move(table.columns);
  const auto keep = [&columns]<class Item>(const std::vector<Item>& items) {
    std::vector<Item> kept;
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c].is_shown) kept.push_back(items[c]);
    return kept;
  };
  table.columns = keep(columns);
  for (auto& row : table.rows) row = keep(row);
  return table;
}

std::string to_markdown(const Table& whole) {
  const Table table = shown(whole);
  std::string out = escape_markdown(table.caption) + "\n\n| ";
  out += joined(table.columns, " | ", [](const Column& column) { return escape_markdown(column.title); }) + " |\n|";
  for (const Column& column : table.columns) out += column.is_number ? " ---: |" : " --- |";
  out += "\n";
  for (const auto& row : table.rows)
    out += "| " + joined(row, " | ", [](const Cell& cell) { return escape_markdown(cell.text); }) + " |\n";
  return out;
}

std::string to_latex(const Table& whole) {
  const Table table = shown(whole);
  std::string out = "% needs \\usepackage{booktabs} and UTF-8 input\n\\begin{table}\n  \\centering\n  \\caption{" +
                    escape_latex(table.caption) + "}\n  \\label{tab:" + table.name + "}\n  \\begin{tabular}{";
  for (const Column& column : table.columns) out += column.is_number ? 'r' : 'l';
  out += "}\n    \\toprule\n    ";
  out += joined(table.columns, " & ", [](const Column& column) { return escape_latex(column.title); }) + " \\\\\n    \\midrule\n";
  for (const auto& row : table.rows)
    out += "    " + joined(row, " & ", [](const Cell& cell) { return escape_latex(cell.text); }) + " \\\\\n";
  return out + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

}  // namespace gibench::report
