#!/usr/bin/env bash
# Builds the kernel of tests/unit/hal_kernel: User-mode Linux, an ordinary program, from Debian's kernel source.
# usage: build.sh CACHE    (JOBS=n: compilers at a time)
set -euo pipefail
cache=$1
here=$(dirname "$(readlink -f "$0")")
source_package=linux-source-6.1

say() { printf 'kernel: %s\n' "$*" >&2; }
die() { say "$*"; exit 2; }

[ "$(uname -m)" = x86_64 ] || die "User-mode Linux runs on x86-64 only; these tests are skipped elsewhere"
version() { LC_ALL=C apt-cache policy "$source_package" 2>/dev/null | awk '$1 == "Candidate:" && $2 != "(none)" { print $2 }'; }
if [ -z "$(version)" ]; then # fresh images have no package lists
    apt-get update -qq || true
    [ -n "$(version)" ] || die "apt offers no $source_package (Debian 12, with its security archive): apt-get update as root, then again"
fi
kernel=$cache/$(version)-$("$here/key.sh")
if [ -x "$kernel/linux" ]; then
    say "$kernel/linux is there"
    exit
fi

mkdir -p "$cache"
work=$(mktemp -d "$cache/build.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
say "downloading $source_package $(version) (139 MB)"
apt-get download -qq "$source_package=$(version)" 2>download.log || { cat download.log >&2; die "the source could not be fetched"; }
say "unpacking (1.2 GB for the time of the build, in $cache)"
dpkg-deb --fsys-tarfile "$source_package"_*.deb | tar -xO "./usr/src/$source_package.tar.xz" |
    tar -xJ --wildcards --exclude='*/Documentation/[a-z]*' --exclude='*/amd/include/*' --exclude='*/boot/dts/*'
rm "$source_package"_*.deb
cd "$source_package"
for change in "$here"/*.patch; do
    patch -p1 --quiet <"$change" || die "$(basename "$change") does not fit $(version)"
done
cp -r "$here/board" drivers/spangle

say "configuring"
{
    make ARCH=um tinyconfig &&
        scripts/kconfig/merge_config.sh -m .config "$here/config" &&
        make ARCH=um olddefconfig
} >config.log 2>&1 || { cat config.log >&2; die "the kernel could not be configured"; }
# An option whose conditions fail is dropped silently.
while read -r line; do
    grep -qx "$line" .config || die "the configuration lost $line"
done < <(grep '^CONFIG' "$here/config")

say "compiling with ${JOBS:-2} jobs; about 3 minutes of one processor's time"
make ARCH=um -j "${JOBS:-2}" linux 2>&1 | tee build.log | awk '/^  (CC|LD|AR)/ && ++n % 200 == 0 { print "kernel: " n " files" > "/dev/stderr" }' ||
    { tail -20 build.log >&2; die "the kernel does not compile"; }
mkdir "$work/done"
strip -o "$work/done/linux" linux
cp .config "$work/done/config"
rm -rf "$kernel"
mv "$work/done" "$kernel"
say "$kernel/linux: $(du -h "$kernel/linux" | cut -f1), $((SECONDS / 60)) min $((SECONDS % 60)) s"
