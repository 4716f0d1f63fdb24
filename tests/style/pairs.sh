#!/usr/bin/env bash
# Headers and sources pair up: a source X.cpp has a header X.h, what X.h declares X.cpp defines, and no two such pairs include
# one another.
source "$(dirname "${BASH_SOURCE[0]}")/files.sh"

# Sources without a header of their name: tests, programs, verbs and parts that one header of their folder lists.
unpaired_sources='_test\.cpp$|(^|/)main\.cpp$|^tests/contract/[a-z]+_checks\.cpp$|^scenes/generators/make_scenes\.cpp$'
unpaired_sources+='|^common/image/plugin/openimageio\.cpp$|^bench/micro/'
unpaired_sources+='|^bench/app/(check|compare|completion|help|list|query|reference|relight|report|run|study)\.cpp$'
unpaired_sources+='|^bench/study/(study_manifest|study_references)\.cpp$'
unpaired_sources+='|^methods/antiradiance/[a-z_]+_strategy\.cpp$'
unpaired_sources+='|^reports/collect/(collect_relight|collect_result)\.cpp$'
unpaired_sources+='|^reports/tables/(outcome_tables|relight_tables|split_tables)\.cpp$'
# The headers that list those parts.
unpaired_headers='^bench/(app/verbs|study/study_runner)\.h$|^reports/(collect/(collect|error_reading)|tables/study_tables)\.h$'
unpaired_headers+='|^methods/antiradiance/strategy\.h$|^tests/contract/contract\.h$'

said=$(own_files | grep -E '\.(cpp|h|cpp\.in)$' | awk -v sources="$unpaired_sources" -v headers="$unpaired_headers" '
  function stem(path) { sub(/\.(h|cpp|cpp\.in)$/, "", path); return path }
  # The function that a statement at the left margin declares or defines; empty where it does neither.
  function name_in(text) {
    if (text !~ /^[A-Za-z_:\[]/ || !match(text, /[ *&][a-z_0-9]+\(/)) return ""
    return substr(text, RSTART + 1, RLENGTH - 2)
  }
  function is_whole(text) {
    return text ~ /^(inline|constexpr|template|using|typedef|friend|class|struct|enum|union|extern|namespace|static)[^a-z_]/
  }
  function read_source(file, line, name) {
    if ((name = name_in(line)) == "") return
    defined[stem(file), name] = 1
    if (file ~ /\.in$/) made[name] = 1  # by the build, from a file of another name
  }
  function read_header(file, line, name) {
    if (statement == "" && line !~ /^[A-Za-z\[]/) return
    statement = statement (statement == "" ? "" : " ") line
    if (line !~ /[;{]$/ && line != "") return
    if (line ~ /;$/ && !is_whole(statement) && (name = name_in(statement)) != "" && file !~ headers)
      declared[stem(file), name] = file
    statement = ""
  }
  {
    file = $0
    files[++count] = file
    if (file ~ /\.h$/) has_header[stem(file)] = 1
    statement = ""
    while ((getline line < file) > 0) {
      if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/) {
        split(line, parts, "\"")
        includes[stem(file), stem(parts[2])] = file
        continue
      }
      sub(/[ \t]*\/\/.*/, "", line)
      if (file ~ /\.h$/) read_header(file, line)
      else read_source(file, line)
    }
    close(file)
  }
  END {
    for (i = 1; i <= count; ++i)
      if (files[i] ~ /\.cpp$/ && !(stem(files[i]) in has_header) && files[i] !~ sources)
        print files[i] ": has no header of its name"
    for (key in declared) {
      split(key, parts, SUBSEP)
      if (!(key in defined) && !(parts[2] in made))
        print declared[key] ": " parts[2] "() is not defined in " parts[1] ".cpp"
    }
    for (key in includes) {
      split(key, parts, SUBSEP)
      if (parts[1] < parts[2] && (parts[2], parts[1]) in includes)
        print includes[key] ": " parts[1] " and " parts[2] " include one another"
    }
  }')
if [ -n "$said" ]; then fault "$said"; fi
finish
