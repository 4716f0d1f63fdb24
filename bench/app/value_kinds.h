/// The kinds of values that arguments and options take: shown in the help as their type, and what shell completion goes by.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace gibench::value_kind {

inline constexpr const char* scene = "SCENE";         ///< scene file, model file or the name of a known scene
inline constexpr const char* method = "METHOD";       ///< a method's name
inline constexpr const char* setting = "NAME=VALUE";  ///< a parameter of the method that --method names
inline constexpr const char* preset = "PRESET";       ///< a preset of that method
inline constexpr const char* effects = "EFFECTS";     ///< names of effects, commas between
inline constexpr const char* study = "STUDY";         ///< study file, or the name of one that comes with the program
inline constexpr const char* listed = "NAME";         ///< of what the argument before it says: methods, scenes, …
inline constexpr const char* verb = "VERB";           ///< a verb of the program
inline constexpr const char* file = "FILE";
inline constexpr const char* folder = "FOLDER";

}  // namespace gibench::value_kind

namespace gibench {

/// An argument that takes one of these words and no other: its type is the words with bars between.
CLI::Option* take_one_of(CLI::Option* option, const std::vector<std::string>& words);

}  // namespace gibench
