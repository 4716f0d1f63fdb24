/// make_scenes FOLDER: writes every procedural scene into a folder. Run by the build.
#include <cstdio>
#include <exception>

#include "common/core/error.h"
#include "scenes/generators/colonnade.h"
#include "scenes/generators/library.h"
#include "scenes/generators/living_room.h"

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fputs("make_scenes: one folder is wanted; write make_scenes FOLDER\n", stderr);
    return 2;
  }
  try {
    std::printf("colonnade: %zu triangles\n", gibench::generators::write_colonnade(arguments[1]));
    std::printf("living-room: %zu triangles\n", gibench::generators::write_living_room(arguments[1]));
    std::printf("library: %zu triangles\n", gibench::generators::write_library(arguments[1]));
    return 0;
  } catch (const gibench::InputError& error) {
    std::fprintf(stderr, "make_scenes: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_scenes: %s\n", error.what());
    return 4;
  }
}
