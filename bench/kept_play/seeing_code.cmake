# Writes OUT: the sum of all files that LIST names, and of the compiler BUILD, as a string in C++.
file(STRINGS ${LIST} sources)
set(all "${BUILD}\n")
foreach(source IN LISTS sources)
  file(SHA256 ${source} sum)
  file(RELATIVE_PATH name ${ROOT} ${source})
  string(APPEND all "${name} ${sum}\n")
endforeach()
string(SHA256 sum "${all}")
string(SUBSTRING ${sum} 0 16 sum)
file(WRITE ${OUT} "// Made by seeing_code.cmake.
#include \"bench/kept_play/kept_game.hpp\"

namespace teamsight::kept_play {

std::string_view seeing_code() {
  return \"${sum}\";
}

}  // namespace teamsight::kept_play
")
