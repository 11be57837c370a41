// The page's own script: choices, frames, the mouse, and the comparison with what the native program drew.
"use strict";

const $ = (id) => document.getElementById(id);
const tierNames = ["exact", "balanced", "fast"];
let core = null; // the functions of page.cpp
let memoryOf = null; // the bytes of WebAssembly
let scenes = [], boards = [];
const choice = { board: 0, scene: 0, tier: 0, format: 0 };
const results = new Map(); // of a choice: true, when it was drawn as the native program drew it
let running = true, broken = false;
let yaw = 0, pitch = 0;

async function wasmBytes() {
  const packed = Uint8Array.from(atob($("wasm").textContent), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function bind(module) {
  const text = (name, words = []) => module.cwrap("page_" + name, "string", words);
  const number = (name, words = []) => module.cwrap("page_" + name, "number", words);
  const four = ["number", "number", "number", "number"];
  memoryOf = () => module.HEAPU8.buffer;
  return {
    scenes: text("scenes"), boards: text("boards"), formats: text("formats", ["number"]), open: text("open", four),
    draw: text("draw", ["number"]), present: text("present"), bus: text("bus"), violations: text("violations"), digest: text("digest", four),
    glass: number("glass"), memory: number("memory"), width: number("width"), height: number("height"),
    hasCamera: number("has_camera"), orbit: number("orbit", ["number", "number"]), busy: number("busy_ns"),
    bytes: number("frame_bytes"), commands: number("frame_commands"),
  };
}

const lines = (text) => text.split("\n").filter((line) => line !== "");
const keyOf = (c) => [c.board, c.scene, c.tier, c.format].join();
const thousands = (n) => n.toLocaleString("en");

function fill(select, names) {
  select.replaceChildren(...names.map((name, i) => new Option(name, i)));
}

function complain(words) {
  broken = words !== "";
  $("problem").hidden = !broken;
  $("problem").textContent = words;
}

// --- choices

/** The choice as a link carries it: names, which stay when the lists grow. */
function toLink() {
  const words = new URLSearchParams({
    scene: scenes[choice.scene][0], board: boards[choice.board][0], tier: tierNames[choice.tier], colours: $("format").selectedOptions[0].text,
  });
  history.replaceState(null, "", "#" + words);
}

function fromLink() {
  const words = new URLSearchParams(location.hash.slice(1));
  const find = (list, name, otherwise) => Math.max(list.indexOf(name), 0) || (list.includes(name) ? 0 : otherwise);
  choice.scene = find(scenes.map((s) => s[0]), words.get("scene"), scenes.findIndex((s) => s[0] === "S9"));
  choice.board = find(boards.map((b) => b[0]), words.get("board"), 0);
  choice.tier = find(tierNames, words.get("tier"), 0);
  fill($("format"), lines(core.formats(choice.board)));
  choice.format = find(lines(core.formats(choice.board)), words.get("colours"), 0);
}

function showChoice() {
  for (const name of ["scene", "board", "format"]) $(name).value = choice[name];
  document.querySelector(`input[name=tier][value="${choice.tier}"]`).checked = true;
}

function open() {
  showChoice();
  complain(core.open(choice.board, choice.scene, choice.tier, choice.format));
  const camera = !broken && core.hasCamera() === 1;
  $("glass").classList.toggle("flat", !camera);
  $("front").disabled = !camera;
  $("camera").textContent = camera ? "Drag, or press the arrow keys, to walk around." : "This scene has no perspective to walk around in.";
  yaw = pitch = 0;
  meter.restart();
  toLink();
  showBadge();
  if (!broken) frame();
}

// --- frames

const meter = {
  since: 0, frames: 0, sums: [0, 0, 0],
  restart() { this.since = performance.now(); this.frames = 0; this.sums = [0, 0, 0]; },
  add(times) {
    this.frames++;
    times.forEach((t, i) => { this.sums[i] += t; });
    const passed = performance.now() - this.since;
    if (passed < 500 && running) return;
    $("rate").textContent = running ? (1000 * this.frames / passed).toFixed(0) + " per second" : "paused";
    ["draw", "present", "scan"].forEach((id, i) => { $(id).textContent = (this.sums[i] / this.frames).toFixed(2) + " ms"; });
    this.restart();
  },
};

function paint(canvas, at) {
  const width = core.width(), height = core.height();
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
    // As tall as fits beside the numbers, in whole pixels of the display where there is room.
    canvas.style.setProperty("--wide", Math.max(1, Math.floor(Math.min(640 / width, 480 / height))) * width + "px");
  }
  const pixels = new Uint8ClampedArray(memoryOf(), at, 4 * width * height);
  canvas.getContext("2d", { willReadFrequently: true }).putImageData(new ImageData(pixels, width, height), 0, 0);
}

/** The next frame, or for a viewer who moved while all stands still the last one again. */
function frame(next = true) {
  const busyBefore = core.busy(), times = [performance.now()];
  complain(core.draw(next ? 1 : 0) || (times.push(performance.now()), core.present()));
  if (broken) return;
  times.push(performance.now());
  const glass = core.glass();
  times.push(performance.now());
  paint($("glass"), glass);
  paint($("memory"), core.memory());
  const wire = (core.busy() - busyBefore) / 1e6;
  $("bytes").textContent = thousands(core.bytes());
  $("commands").textContent = thousands(core.commands());
  $("wire").textContent = wire.toFixed(2) + " ms";
  $("carries").textContent = wire > 0 ? (1000 / wire).toFixed(0) + " per second" : "-";
  const bus = core.bus();
  if ($("bus").textContent !== bus) $("bus").textContent = bus;
  const rules = lines(core.violations());
  $("violations").textContent = rules.length === 0 ? "none" : String(rules.length);
  $("violations").title = rules.slice(0, 5).join("\n");
  meter.add([times[1] - times[0], times[2] - times[1], times[3] - times[2]]);
}

function loop() {
  if (running && !broken) frame();
  requestAnimationFrame(loop);
}

function run(on) {
  running = on;
  $("pause").textContent = on ? "Pause" : "Go on";
  $("step").disabled = on;
  if (!on) $("rate").textContent = "paused";
  meter.restart();
}

// --- the viewer

function lookFrom(newYaw, newPitch) {
  yaw = newYaw % 360;
  pitch = Math.max(-89, Math.min(89, newPitch));
  core.orbit(yaw, pitch);
  if (!running && !broken) frame(false);
}

function listenToViewer() {
  const glass = $("glass");
  let from = null;
  glass.addEventListener("pointerdown", (e) => {
    if (glass.classList.contains("flat")) return;
    from = [e.clientX, e.clientY, yaw, pitch];
    glass.setPointerCapture(e.pointerId);
  });
  glass.addEventListener("pointermove", (e) => {
    if (from !== null) lookFrom(from[2] + (e.clientX - from[0]) / 3, from[3] + (e.clientY - from[1]) / 3);
  });
  for (const end of ["pointerup", "pointercancel"]) glass.addEventListener(end, () => { from = null; });
  glass.addEventListener("keydown", (e) => {
    const turn = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5], Home: [-yaw, -pitch] }[e.key];
    if (turn === undefined || glass.classList.contains("flat")) return;
    e.preventDefault();
    lookFrom(yaw + turn[0], pitch + turn[1]);
  });
  $("front").addEventListener("click", () => lookFrom(0, 0));
}

// --- the comparison

let compared = 0, equal = 0, cases = [];

function showBadge() {
  const done = compared === cases.length, badge = $("badge");
  badge.className = equal < compared ? "different" : done ? "equal" : "pending";
  const here = results.get(keyOf(choice));
  const all = !done ? `comparing with native: ${compared} of ${cases.length}`
    : equal === compared ? `same hash as native: ${equal} of ${compared}`
    : `not the same as native: ${compared - equal} of ${compared}`;
  badge.textContent = (badge.className === "equal" ? "\u2713 " : "") + all;
  $("here").textContent = here !== undefined ? (here ? "same hash" : "another hash")
    : cases.some((c) => keyOf(named(c)) === keyOf(choice)) ? "not yet compared" : "not compared";
}

function row(c, same) {
  const tr = document.createElement("tr");
  const words = [scenes[c.scene][0], tierNames[c.tier], boards[c.board][0], lines(core.formats(c.board))[c.format], same ? "equal" : "different"];
  for (const word of words) tr.insertCell().textContent = word;
  tr.lastChild.className = words[4];
  return tr;
}

const named = ([board, scene, tier, format]) => ({ board, scene, tier, format });

async function compare() {
  for (const words of cases) {
    const c = named(words), same = core.digest(c.board, c.scene, c.tier, c.format) === words[4];
    results.set(keyOf(c), same);
    compared++;
    equal += same ? 1 : 0;
    $("results").append(row(c, same));
    if (compared === cases.length || compared % 8 === 0 || !same) showBadge();
    await new Promise((resolve) => { setTimeout(resolve); });
  }
}

// --- the beginning

async function start() {
  core = bind(await spanglePage({ wasmBinary: await wasmBytes() }));
  scenes = lines(core.scenes()).map((line) => line.split("\t"));
  boards = lines(core.boards()).map((line) => line.split("\t"));
  cases = JSON.parse($("native").textContent);
  fill($("scene"), scenes.map(([id, title]) => id + ": " + title));
  fill($("board"), boards.map(([, summary]) => summary));
  fromLink();
  for (const name of ["scene", "format"]) $(name).addEventListener("change", () => { choice[name] = Number($(name).value); open(); });
  $("board").addEventListener("change", () => {
    choice.board = Number($("board").value);
    choice.format = 0;
    fill($("format"), lines(core.formats(choice.board)));
    open();
  });
  for (const radio of document.getElementsByName("tier"))
    radio.addEventListener("change", () => { choice.tier = Number(radio.value); open(); });
  $("pause").addEventListener("click", () => run(!running));
  $("step").addEventListener("click", () => { if (!broken) frame(); });
  listenToViewer();
  run(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  open();
  loop();
  await compare();
}

start().catch((error) => {
  $("badge").className = "different";
  $("badge").textContent = "this browser cannot run the page";
  complain(String(error));
});
