// Stands in for Assimp on a file that it does not survive: the file's first word says how.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "bench/app/model_process.h"
#include "bench/app/program.h"

namespace {

[[noreturn]] void go_on_for_ever() {
  for (;;) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// A GiB, each page touched.
void take_memory() {
  std::vector<std::vector<char>> taken;
  for (int i = 0; i < 1024; ++i) taken.emplace_back(std::size_t{1} << 20U, 'x');
  go_on_for_ever();
}

gibench::Model read_oddly(const std::filesystem::path& file, const std::string& place, bool with_materials) {
  std::string word;
  std::ifstream(file) >> word;
  std::printf("a library's own line\n");
  std::ofstream(file.parent_path() / "reader-began") << getpid();
  if (word == "crash") std::abort();
  if (word == "exit") std::_Exit(3);
  if (word == "loop") go_on_for_ever();
  if (word == "memory") take_memory();
  return gibench::read_model(file, place, with_materials);
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto status = gibench::answer_as_model_process(argc, argv, read_oddly)) return *status;
  return gibench::run_program(argc, argv);
}
