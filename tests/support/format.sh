# The format of the C++ files, for scripts that source this at the top of the sources. Lists of files stand on standard
# input and output, each file ended by a zero byte.
#   all_code       prints that list of all files of the work tree, new ones too
#   format_check   fails if a file is formatted differently, and prints the command that mends it
#   format_fix     formats them
# Versions of clang-format differ; the sources are formatted by version 14, which is taken where it is installed.
clang_format() {
  command -v clang-format-14 || command -v clang-format ||
    { app/setup --only clang-format >&2 && command -v clang-format; }
}

all_code() {
  git ls-files -z --cached --others --exclude-standard '*.cpp' '*.h' | while IFS= read -rd '' file; do
    if [[ -f $file ]]; then printf '%s\0' "$file"; fi
  done
}

format_check() {
  local format
  format=$(clang_format) || return
  xargs -0 -r -n 40 -P "$(nproc)" "$format" --dry-run -Werror || {
    echo "format: formatted differently than .clang-format says (above); to mend it: tests/quick --fix" >&2
    return 1
  }
}

format_fix() {
  local format
  format=$(clang_format) || return
  xargs -0 -r -n 40 -P "$(nproc)" "$format" -i
}
