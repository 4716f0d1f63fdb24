#include "bench/app/model_process.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string_view>

#include "bench/app/child_guard.h"
#include "bench/measure/cancellation.h"
#include "bench/study/child_process.h"
#include "common/core/error.h"
#include "common/core/find_file.h"
#include "common/scene_io/models/model_bytes.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

// The first argument of such a child: no option of the program, and in no help.
constexpr std::string_view child_call = "--as-model-process";

/// What the child has to say, in the first byte of its answer.
enum class Answer : char { model = 'M', bad_input = 'I', missing_file = 'F', failed = 'W' };

/// A file without a place in the file system, which a child writes and its parent reads.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("gibench", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw WorkError(std::string("no memory file can be made: ") + std::strerror(errno));
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// In this process, and in a child until it becomes another program.
  fs::path path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

/// `problem` as an error of `place`, which it names already where a reader threw it there.
template <class Error>
[[noreturn]] void throw_again(std::string_view problem, const std::string& place) {
  if (problem.starts_with(place + ": ")) problem.remove_prefix(place.size() + 2);
  throw Error(place, std::string(problem));
}

constexpr const char* convert = "convert it to glTF, which gibench reads itself";

[[noreturn]] void refuse_crash(const std::string& place, const std::string& how) {
  throw InputError(place, "crashes the reader of its format (" + how + ")", convert);
}

Model model_of_answer(std::string_view answer, const std::string& place) {
  const std::string_view rest = answer.substr(std::min<std::size_t>(1, answer.size()));
  switch (answer.empty() ? Answer::failed : static_cast<Answer>(answer.front())) {
    case Answer::model: try { return model_of_bytes(rest);
      } catch (const WorkError&) {
        refuse_crash(place, "it hands on no model");
      }
    case Answer::bad_input: throw_again<InputError>(rest, place);
    case Answer::missing_file: throw_again<MissingFileError>(rest, place);
    case Answer::failed: break;
  }
  throw WorkError(rest.empty() ? place + ": its reader gave no answer" : std::string(rest));
}

Model read_in_child(const fs::path& file, const std::string& place, bool with_materials, const ModelLimits& limits) {
  const MemoryFile answer;
  const std::vector<std::string> arguments{std::string(child_call), file.string(), place,
                                           with_materials ? "materials" : "geometry"};
  const ChildLimits child_limits{static_cast<double>(limits.seconds), std::uint64_t{limits.mebibytes} << 20U};
  const ChildResult child = run_child(arguments, child_limits, {answer.path(), "/dev/null", {}});
  stop_if_cancelled();
  switch (child.end) {
    case ChildEnd::timed_out:
      throw InputError(place, fmt::format("took over {} s to be read", limits.seconds),
                       std::string(convert) + ", or raise --model-seconds");
    case ChildEnd::over_memory:
      throw InputError(place, fmt::format("needed over {} MiB to be read", limits.mebibytes),
                       std::string(convert) + ", or raise --model-memory");
    case ChildEnd::signalled: refuse_crash(place, describe_signal(child.signal));
    case ChildEnd::cancelled:
    case ChildEnd::exited: break;
  }
  if (child.exit_code != 0) refuse_crash(place, fmt::format("exit status {}", child.exit_code));
  return model_of_answer(child.out, place);
}

std::string answer_of(const ModelReader& reader, char** argv) {
  const auto with = [](Answer kind, const std::string& text) { return std::string(1, static_cast<char>(kind)) + text; };
  try {
    return with(Answer::model, bytes_of(reader(argv[2], argv[3], std::string_view(argv[4]) == "materials")));
  } catch (const MissingFileError& error) {
    return with(Answer::missing_file, error.what());
  } catch (const InputError& error) {
    return with(Answer::bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return with(Answer::failed, std::string(argv[3]) + ": out of memory; " + convert);
  } catch (const std::exception& error) {
    return with(Answer::failed, error.what());
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
  }
  return true;
}

}  // namespace

ModelReader reader_in_child(const ModelLimits& limits) {
  return [limits](const fs::path& file, const std::string& place, bool with_materials) {
    return is_read_by_assimp(file) ? read_in_child(file, place, with_materials, limits) : read_model(file, place, with_materials);
  };
}

std::optional<int> answer_as_model_process(int argc, char** argv, const ModelReader& reader) {
  if (argc != 5 || child_call != argv[1]) return std::nullopt;
  die_with_parent();
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int answer = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);  // libraries may print: into nothing
  return write_all(answer, answer_of(reader, argv)) ? 0 : 4;
}

}  // namespace gibench
