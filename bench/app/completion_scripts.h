/// The shells' completion scripts of the folder completion/, as text in the program.
#pragma once

namespace gibench {

const char* bash_completion();
const char* zsh_completion();
const char* fish_completion();

}  // namespace gibench
