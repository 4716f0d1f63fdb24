#include "bench/app/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "bench/app/call_tree.h"
#include "bench/app/child_guard.h"
#include "bench/app/exit_status.h"
#include "bench/app/model_process.h"
#include "bench/app/signals.h"
#include "bench/app/verbs.h"
#include "bench/measure/run_method.h"
#include "bench/record/machine.h"
#include "common/core/did_you_mean.h"
#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/core/printable_text.h"
#include "methods/registry.h"

namespace gibench {

namespace {

int failed(ExitStatus status, ErrorCode code, const std::string& message) {
  const std::string text = printable_text(message);
  std::fprintf(stderr, "gibench: %s\n", text.c_str());
  tell_parent({code, text});
  return static_cast<int>(status);
}

/// The verb whose options a parse error is about, for the hint.
std::string called_verb(const CLI::App& app) {
  const auto verbs = app.get_subcommands();
  return verbs.empty() ? "gibench" : "gibench " + verbs.front()->get_name();
}

/// The option of the verb that is near to one that it does not take, if the parse failed for that.
std::string near_option(const CLI::App& app, const CallTree& tree) {
  const auto verbs = app.get_subcommands();
  const CallVerb* verb = verbs.empty() ? nullptr : tree.find(verbs.front()->get_name());
  if (!verb) return {};
  std::vector<std::string> names;
  for (const CallOption& option : verb->options)
    if (!option.is_argument()) names.push_back(option.names.back());
  for (const std::string& word : app.remaining(true))
    if (word.starts_with("--"))
      if (const std::string near = did_you_mean(word.substr(0, word.find('=')), names); !near.empty()) return near;
  return {};
}

bool is_verb(const CLI::App& app, const std::string& word) {
  return !app.get_subcommands([&](const CLI::App* verb) { return verb->check_name(word); }).empty();
}

int wrong_call(const std::string& text) { return failed(ExitStatus::bad_input, ErrorCode::bad_input, text); }

int run_verb(int argc, char** argv, const std::vector<MethodEntry>& own_methods) {
  for (const MethodEntry& entry : own_methods) add_method(entry);
  CLI::App app("Compares light-transport methods on the same scenes: how much accuracy does a second buy?", "gibench");
  app.set_version_flag("--version", version() + " (" + commit() + ")");
  app.require_subcommand(1);
  Call call;
  add_verbs(app, call);
  try {
    // CLI11 would say of an unknown verb only that one is required.
    if (argc > 1 && argv[1][0] != '-' && !is_verb(app, argv[1]))
      return wrong_call(
          fmt::format("unknown verb '{}'; {}see gibench --help", argv[1], did_you_mean(argv[1], call_tree(app).verb_names())));
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return wrong_call(fmt::format("{}; {}see {} --help", error.what(), near_option(app, call_tree(app)), called_verb(app)));
  }
  return static_cast<int>(call.action());
}

int guarded(int argc, char** argv, const std::vector<MethodEntry>& own_methods) {
  try {
    return run_verb(argc, argv, own_methods);
  } catch (const MissingFileError& error) {
    return failed(ExitStatus::bad_input, ErrorCode::missing_file, error.what());
  } catch (const InputError& error) {
    return failed(ExitStatus::bad_input, ErrorCode::bad_input, error.what());
  } catch (const MethodRefusal& error) {
    return failed(ExitStatus::work_failed, ErrorCode::refused, error.what());
  } catch (const std::bad_alloc&) {
    return failed(ExitStatus::work_failed, ErrorCode::out_of_memory, "out of memory; ask for fewer samples or a smaller scene");
  } catch (const std::exception& error) {
    return failed(ExitStatus::work_failed, ErrorCode::work_failed, error.what());
  }
}

}  // namespace

int run_program(int argc, char** argv, const std::vector<MethodEntry>& own_methods) {
  if (const auto status = answer_as_model_process(argc, argv)) return *status;
  die_with_parent();
  listen_for_cancellation();
  const int status = guarded(argc, argv, own_methods);
  // Answers that could not be written to stdout (a full disk) count as failure.
  if ((std::fflush(stdout) != 0 || std::ferror(stdout) != 0) && status == 0)
    return failed(ExitStatus::work_failed, ErrorCode::work_failed, "stdout: cannot be written to");
  return status;
}

}  // namespace gibench
