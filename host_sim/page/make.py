#!/usr/bin/env python3
"""Makes the page: one HTML file that opens from a folder.

usage: make.py NATIVE_HASHES FOLDER [--jobs N]

NATIVE_HASHES is the program spangle_page_hashes. The page is written to FOLDER/index.html; emscripten builds in FOLDER/wasm.
"""
import argparse
import base64
import os
import pathlib
import subprocess
import sys
import zlib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))
import outfile  # noqa: E402


def build(folder, jobs):
    # Without this variable, Debian's emscripten looks for its JavaScript parser among node's own packages.
    environment = {**os.environ, "NODE_PATH": "/usr/share/nodejs"}
    for command in (["emcmake", "cmake", "-S", str(HERE), "-B", str(folder), "-G", "Ninja"],
                    ["cmake", "--build", str(folder), "-j", str(jobs)]):
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{done.stdout[-4000:]}\n{' '.join(command)} failed")


def pack(native, folder):
    def put(page, place, content):
        assert page.count(place) == 1, place
        return page.replace(place, content)

    # The text "</script" in a string of JavaScript would end the script.
    script = lambda text: f"<script>\n{text.replace('</script', '<' + chr(92) + '/script')}</script>"
    page = (HERE / "page.html").read_text()
    page = put(page, '<link rel="stylesheet" href="page.css">', f"<style>\n{(HERE / 'page.css').read_text()}</style>")
    page = put(page, '<script src="page.js"></script>', script((HERE / "page.js").read_text()))
    page = put(page, '<script src="loader.js"></script>', script((folder / "page.js").read_text()))
    page = put(page, 'id="native">', f'id="native">{native}')
    wasm = zlib.compress((folder / "page.wasm").read_bytes(), 9)
    return put(page, 'id="wasm">', f'id="wasm">{base64.b64encode(wasm).decode()}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("hashes")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    words = parser.parse_args()
    native = subprocess.run([words.hashes], check=True, stdout=subprocess.PIPE, text=True).stdout
    words.folder.mkdir(parents=True, exist_ok=True)
    build(words.folder / "wasm", words.jobs)
    page = words.folder / "index.html"
    outfile.write(page, pack(native, words.folder / "wasm"))
    print(f"{page}: {page.stat().st_size:,} bytes, compared with {native.count('[') - 1} native hashes")


if __name__ == "__main__":
    sys.exit(outfile.checked(main))
