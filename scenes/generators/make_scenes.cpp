/// make_scenes FOLDER: writes every procedural scene into a folder. Run by the build.
#include <cstdio>
#include <exception>

#include "common/core/error.h"
#include "scenes/generators/colonnade.h"

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fputs("make_scenes: one folder is wanted; write make_scenes FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::size_t triangles = gibench::generators::write_colonnade(arguments[1]);
    std::printf("colonnade: %zu triangles\n", triangles);
    return 0;
  } catch (const gibench::InputError& error) {
    std::fprintf(stderr, "make_scenes: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_scenes: %s\n", error.what());
    return 4;
  }
}
