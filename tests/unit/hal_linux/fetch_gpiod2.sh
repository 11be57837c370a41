#!/usr/bin/env bash
# Unpacks Debian's libgpiod 2 (bookworm-backports) into a folder beside the installed version 1. Needs no root.
# usage: fetch_gpiod2.sh FOLDER
set -euo pipefail
folder=${1:?usage: fetch_gpiod2.sh FOLDER}
[ -e "$folder/complete" ] && exit
command -v apt-get >/dev/null || { echo "fetch_gpiod2.sh: this is not a Debian system" >&2; exit 1; }
mkdir -p "$folder"/apt/{lists/partial,cache/archives/partial}
cd "$folder/apt"
echo 'deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm-backports main' >sources.list
options=(-qq -o Dir::Etc::SourceList="$PWD/sources.list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$PWD/lists"
    -o Dir::Cache="$PWD/cache" -o APT::Sandbox::User= -o Acquire::http::Timeout=20 -o Acquire::Retries=1)
apt-get "${options[@]}" update
apt-get "${options[@]}" download libgpiod3 libgpiod-dev
for package in ./*.deb; do dpkg-deb -x "$package" "$folder"; done
cd "$folder"
rm -rf apt
touch complete
