# Set-up shared by all scripts of the project. To be sourced by bash, not run:
#
#   set -euo pipefail
#   source "$(dirname "${BASH_SOURCE[0]}")/../tests/setup.sh"
#   selvage_need_groups build tests
#   selvage_logged configure cmake -S "$selvage_top" -B "$selvage_top/build" -G Ninja
#
# Needs bash, coreutils and dpkg; whatever else a script wants, it asks for with selvage_need.
# Exit statuses of the scripts: 0 fine, 1 a finding or a failure, 2 wrong use or a missing package.

selvage_top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
selvage_name=${0#"$PWD"/}              # how the script was called, for messages
selvage_logs=$selvage_top/build/logs   # one file a step; a script may choose another folder
export LC_ALL=C.UTF-8

# Packages by purpose. Names are Debian 12's.
declare -A selvage_groups=(
  [build]="g++ cmake ninja-build pkg-config libhwy-dev libtbb-dev libeigen3-dev"
  [tests]="librapidcheck-dev libgtest-dev libbenchmark-dev gappa valgrind libgmp-dev
           libopencv-core-dev libopencv-imgproc-dev
           libpng-dev libturbojpeg0-dev libcli11-dev nlohmann-json3-dev libtinyobjloader-dev
           libsdl2-dev xvfb xdotool python3"
  [cross]="g++-aarch64-linux-gnu qemu-user-static"
  [cross32]="g++-arm-linux-gnueabihf qemu-user-static"
  [bare_metal]="gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib
                qemu-system-arm"
  [clang]="clang-19 libclang-rt-19-dev llvm-19"
  [fuzz]="clang-19 libclang-rt-19-dev llvm-19 zip
          libgmp-dev libpng-dev libturbojpeg0-dev libcli11-dev nlohmann-json3-dev"
  [coverage]="clang-19 libclang-rt-19-dev llvm-19 lcov python3"
  [mutants]="clang-19 python3 python3-clang-19"
  [format]="clang-format"
  [reports]="xplanet-images gnuplot-nox libbenchmark-dev"
  [peers]="qt6-base-dev liballegro4-dev libosmesa6-dev libsdl2-dev libpixman-1-dev libcairo2-dev
           libagg-dev"
)

# selvage_fail STATUS MESSAGE: says the message on stderr and leaves.
selvage_fail() {
  printf '%s: %s\n' "$selvage_name" "$2" >&2
  exit "$1"
}

# selvage_missing PACKAGE...: prints those that are not installed, one a line.
selvage_missing() {
  local package
  for package in "$@"; do
    case " $(dpkg-query -W -f='${db:Status-Status} ' "$package" 2>/dev/null || true) " in
      *" installed "*) ;;
      *) printf '%s\n' "$package" ;;
    esac
  done
}

# selvage_need PACKAGE...: installs what is missing, and only that. Where nothing is missing it
# touches neither apt nor the network. SELVAGE_SETUP=skip trusts that everything is there.
selvage_need() {
  [ "${SELVAGE_SETUP:-}" != skip ] || return 0
  command -v dpkg-query >/dev/null || selvage_fail 2 \
    "set-up knows Debian's packages only, and there is no dpkg-query here.
Provide what these Debian packages hold, then call again with SELVAGE_SETUP=skip:
  $*"
  local missing apt=() reason="" status=0
  mapfile -t missing < <(selvage_missing "$@" | sort -u)
  [ "${#missing[@]}" -gt 0 ] || return 0

  if ! command -v apt-get >/dev/null; then
    reason="there is no apt-get"
  elif [ "$(id -u)" = 0 ]; then
    apt=()
  elif ! command -v sudo >/dev/null; then
    reason="this is not root and there is no sudo"
  elif [ -t 0 ] && [ -t 2 ]; then
    apt=(sudo)
  elif sudo -n true 2>/dev/null; then
    apt=(sudo -n)
  else
    reason="this is not root, and sudo wants a password but has no terminal to ask on"
  fi
  if [ -z "$reason" ]; then
    printf 'set-up: installing %s\n' "${missing[*]}"
    mkdir -p "$selvage_logs"
    # sudo asks for its password before the output goes to a log.
    [ "${apt[*]}" != sudo ] || sudo -v || selvage_fail 2 "sudo refused"
    apt+=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=120 -q -y)
    compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null ||
      selvage_quietly setup "${apt[@]}" update || status=$?
    [ "$status" = 0 ] && selvage_quietly setup "${apt[@]}" install --no-install-recommends \
      "${missing[@]}" || status=$?
    if [ "$status" != 0 ]; then  # the lists may be older than the mirror
      status=0
      selvage_quietly setup "${apt[@]}" update &&
        selvage_quietly setup "${apt[@]}" install --no-install-recommends "${missing[@]}" ||
        status=$?
    fi
    mapfile -t missing < <(selvage_missing "$@" | sort -u)
    [ "${#missing[@]}" -gt 0 ] || return 0
    tail -n 5 "$selvage_logs/setup.log" >&2
    reason="apt-get could not install them (log: $selvage_logs/setup.log)"
  fi
  selvage_fail 2 "missing packages: ${missing[*]}
They could not be installed: $reason. The command that installs them, as root, with network:
  apt-get update && apt-get install --no-install-recommends ${missing[*]}"
}

# selvage_need_groups GROUP...: the same for the groups above.
selvage_need_groups() {
  local group packages=()
  for group in "$@"; do
    # Word splitting is what turns a group into its packages.
    # shellcheck disable=SC2206
    packages+=(${selvage_groups[$group]})
  done
  selvage_need "${packages[@]}"
}

# selvage_quietly STEP COMMAND...: runs the command with its output appended to STEP.log. A terminal
# sees the log's last line as progress; the command's status is returned.
selvage_quietly() {
  local log=$selvage_logs/$1.log ticker="" status=0
  shift
  mkdir -p "$selvage_logs"
  if [ -t 2 ]; then
    while sleep 1; do
      printf '\r\033[K%s' "$(tail -n 1 "$log" 2>/dev/null | tr -d '\r' | cut -c1-78)" >&2
    done &
    ticker=$!
  fi
  "$@" >>"$log" 2>&1 </dev/null || status=$?
  if [ -n "$ticker" ]; then
    kill "$ticker" 2>/dev/null || true
    wait "$ticker" 2>/dev/null || true
    printf '\r\033[K' >&2
  fi
  return "$status"
}

# selvage_logged STEP COMMAND...: a step that must succeed. Its output goes to STEP.log, begun anew;
# on failure the end of the log is shown and the script leaves with status 1.
selvage_logged() {
  local step=$1 log=$selvage_logs/$1.log start=$SECONDS
  shift
  mkdir -p "$selvage_logs"
  : >"$log"
  if ! selvage_quietly "$step" "$@"; then
    tail -n 40 "$log" >&2
    selvage_fail 1 "$step failed (log: $log)"
  fi
  printf '%s: done in %d s (log: %s)\n' "$step" $((SECONDS - start)) "${log#"$PWD"/}"
}

# selvage_say_skipped BUILD: the tests that the last run of ctest in that build skipped, by name. For
# ctest a suite passes although some of it was skipped.
selvage_say_skipped() {
  grep -ahE '^\[  SKIPPED \] [^ ]+[.][^ ]+(, where .*)?$' "$1/Testing/Temporary/LastTest.log" |
    sed 's/^\[  SKIPPED \]/skipped:/' | sort -u || true
}
