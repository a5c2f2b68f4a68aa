# Stages of a check, for scripts that source this:
#   stage NAME COMMAND ...   runs the command, and keeps its time and verdict
#   stages_table             prints stage, time and verdict of each, and their total; fails if a stage failed
# A stage that fails ends the script, unless stages_go_on=yes.
stages_go_on=no
stages_failed=0
stages_lines=()

minutes() { printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); }

stage() {
  local name=$1 began=$SECONDS code verdict=good
  shift
  printf '\n== %s ==\n' "$name"
  # In a shell of its own, where any command that fails ends it.
  set +e
  (set -e; "$@")
  code=$?
  set -e
  ((code == 0)) || { verdict=FAILED; stages_failed=$((stages_failed + 1)); }
  stages_lines+=("$(printf '%-24s %14s  %s' "$name" "$(minutes $((SECONDS - began)))" "$verdict")")
  printf -- '-- %s\n' "${stages_lines[-1]}"
  [[ $stages_go_on == yes ]] || return $code
}

stages_table() {
  printf '\n%-24s %14s  %s\n' stage time verdict
  ((${#stages_lines[@]} == 0)) || printf '%s\n' "${stages_lines[@]}"
  printf '%-24s %14s\n' total "$(minutes $SECONDS)"
  ((stages_failed == 0))
}
