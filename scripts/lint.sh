#!/usr/bin/env bash
# The project's own code under -Wall -Wextra -Wpedantic -Werror of g++ and clang++, each public header alone, clang-tidy
# as .clang-tidy says, the format, and catkin_lint. Compiles no object; build/ is configured for its commands.
# Usage: lint.sh [gcc|clang|headers|tidy|format|catkin]...   all when none is named
set -uo pipefail
cd "$(dirname "$0")/.."
export PATH=/usr/bin:$PATH
bash scripts/setup.sh clang clang-tidy-14 clang-format-14 catkin-lint || exit 1
checks=("$@")
if [ $# -eq 0 ]; then checks=(format catkin headers gcc clang tidy); fi
warnings="-std=c++17 -Wall -Wextra -Wpedantic -Werror"

prepare() {
  cmake -S . -B build -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null &&
    cmake --build build --target stillmap_generate_messages_cpp stillmap_version >/dev/null
}

# COMPILER [OPTIONS]: each source as the build compiles it, to the end of its syntax.
syntax() {
  python3 - "$1" $warnings "${@:2}" <<'END' | xargs -d '\n' -P "$(nproc)" -I{} sh -c '{} || exit 255'
import json, os, shlex, sys
for entry in json.load(open("build/compile_commands.json")):
    if os.path.dirname(entry["file"]).startswith(os.path.abspath("build")):
        continue  # made by the build
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if word.endswith(("c++", "g++"))) + 1:]  # after ccache
    output = words.index("-o")
    print(shlex.join([sys.argv[1]] + words[:output] + words[output + 2:] + ["-fsyntax-only"] + sys.argv[2:]))
END
}
check_gcc() { syntax g++; }
check_clang() { syntax clang++ -Wno-bitwise-instead-of-logical; }  # `&` keeps branches out of vector loops
check_headers() {
  for header in include/stillmap/*.hpp; do
    for compiler in g++ clang++; do
      echo "#include \"stillmap/$(basename "$header")\"" |
        $compiler $warnings -fsyntax-only -Iinclude -isystem /usr/include/eigen3 -x c++ - || return 1
    done
  done
}
check_tidy() { git ls-files 'src/*.cpp' | xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build --quiet 2>/dev/null; }
check_format() { git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 --dry-run -Werror; }
check_catkin() { catkin_lint --strict .; }

prepare || exit 1
failed=""
for check in "${checks[@]}"; do
  start=$SECONDS
  if "check_$check"; then result=clean; else result=FAILED failed+=" $check"; fi
  printf '%-8s %s, %d s\n' "$check" $result $((SECONDS - start))
done
if [ -n "$failed" ]; then
  echo "lint.sh: failed:$failed" >&2
  exit 1
fi
