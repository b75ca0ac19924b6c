import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';
import { compile, createSimulation, joinHolds, playScript, type Simulation } from '../engine/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { seeded } from '../tests/scenes/seeded.ts';
import { askedLevels, atLeast, consume, define, LEVELS, median, PROJECT, sum } from './harness/index.ts';
import { type NativeArcade, type NativeScene, startNative } from './native.ts';

const MAX_FRAMES = 3600;
/** Random scripts per level, in addition to its own runs: what a search plays most of its time. */
const SCRIPTS = 48;
const ROUNDS = 15;
/** Shortest time of one sample, ms of processor time, so that other work on the machine matters little. */
const SAMPLE = 5;
/** Frames that a search advances at a time. */
const MACRO = 8;
const WORKER_ROUNDS = 7;
/** How long workers play in a round, ms. */
const WINDOW = 700;

const OUTCOMES = ['lost', 'completed', 'collided'] as const;

/** Presses and pauses of up to 1.5 s at random, up to the last frame. */
function randomScript(random: () => number): Hold[] {
  const length = () => 1 + Math.floor(90 * random());
  const holds: Hold[] = [];
  for (let tick = length(); tick < MAX_FRAMES; ) {
    const release = tick + length();
    holds.push([tick, Math.min(release, MAX_FRAMES)]);
    tick = release + length();
  }
  return holds;
}

const sceneOf = (level: Level, i: number): NativeScene => {
  const random = seeded(i + 1);
  const scripts = Array.from({ length: SCRIPTS }, () => randomScript(random));
  return { level, runs: [...level.runs.map(({ holds }) => joinHolds(holds)), ...scripts] };
};

/** One way to step the engine through all runs of a scene; returns the number of frames. */
type Stepper = () => number;

/** From the start to the end in as few calls as there are presses and releases. */
function wholeRuns(simulation: Simulation, runs: NativeScene['runs']): Stepper {
  const state = new Float64Array(6);
  return () => {
    let frames = 0;
    for (const holds of runs) {
      simulation.reset();
      playScript(simulation, holds, MAX_FRAMES);
      simulation.readState(state);
      consume(state[0] + state[1]);
      frames += simulation.tick;
    }
    return frames;
  };
}

/** The button at every frame. */
function buttonOf(holds: readonly Hold[]): Uint8Array {
  const button = new Uint8Array(MAX_FRAMES);
  for (const [press, release] of holds) button.fill(1, press, release);
  return button;
}

/** One call per frame, as in a playtest. */
function frameByFrame(simulation: Simulation, runs: NativeScene['runs']): Stepper {
  const buttons = runs.map(buttonOf);
  return () => {
    let frames = 0;
    for (const button of buttons) {
      simulation.reset();
      let frame = 0;
      while (frame < MAX_FRAMES && simulation.advance(1, button[frame] === 1) === 1) frame++;
      frames += frame;
    }
    return frames;
  };
}

/** All runs side by side, a few frames of each at a time between restore and snapshot, as in a search. */
function macros(simulation: Simulation, runs: NativeScene['runs']): Stepper {
  const plans = runs.map((holds) => {
    const edges = [...new Set([...holds.flat(), MAX_FRAMES])].sort((a, b) => a - b);
    const button = buttonOf(holds);
    const plan: { ticks: number; held: boolean }[] = [];
    let frame = 0;
    for (const edge of edges) {
      for (; frame < edge; frame += plan[plan.length - 1].ticks) {
        plan.push({ ticks: Math.min(MACRO, edge - frame), held: button[frame] === 1 });
      }
    }
    return plan;
  });
  simulation.reset();
  const start = simulation.snapshot();
  const snapshots = runs.map(() => simulation.snapshot());
  return () => {
    let frames = 0;
    for (const snapshot of snapshots) snapshot.set(start);
    let going = plans.map((_, i) => i);
    for (let k = 0; going.length > 0; k++) {
      going = going.filter((i) => {
        if (k >= plans[i].length) return false;
        const { ticks, held } = plans[i][k];
        simulation.restore(snapshots[i]);
        const advanced = simulation.advance(ticks, held);
        simulation.snapshot(snapshots[i]);
        frames += advanced;
        return advanced === ticks;
      });
    }
    return frames;
  };
}

/**
 * Checks that both end every run in the same frame, with the same outcome and the same bits; otherwise the comparison is void.
 */
function assertSame(scenes: readonly NativeScene[], native: NativeArcade): void {
  const state = new Float64Array(6);
  let k = 0;
  for (const { level, runs } of scenes) {
    const simulation = createSimulation(compile(level, 'arcade'));
    for (const [i, holds] of runs.entries()) {
      simulation.reset();
      playScript(simulation, holds, MAX_FRAMES);
      simulation.readState(state);
      const { ending } = simulation;
      const ours = [
        simulation.tick,
        ending === null ? 0 : 1 + OUTCOMES.indexOf(ending.outcome),
        simulation.mineralCount,
        ...state,
      ];
      const theirs = native.ends[k++];
      const found = [theirs.frames, theirs.outcome, theirs.minerals, ...theirs.state];
      if (ours.some((value, n) => value !== found[n])) {
        throw new Error(`${level.name}, run ${i}: the engine ends in ${ours.join(' ')}, the C++ loop in ${found.join(' ')}`);
      }
    }
  }
}

const WAYS = ['whole', 'frame', 'macro'] as const;

/** Times in ns per frame, for each way of stepping and for the C++ loop, round by round. */
interface Samples {
  readonly whole: number[];
  readonly frame: number[];
  readonly macro: number[];
  readonly native: number[];
}

async function measureScene(
  scene: NativeScene,
  index: number,
  native: NativeArcade,
): Promise<{ samples: Samples; frames: number }> {
  const simulation = () => createSimulation(compile(scene.level, 'arcade'));
  const steppers = {
    whole: wholeRuns(simulation(), scene.runs),
    frame: frameByFrame(simulation(), scene.runs),
    macro: macros(simulation(), scene.runs),
  };
  const frames = steppers.whole();
  const samples: Samples = { whole: [], frame: [], macro: [], native: [] };
  const timesOf = (ns: number) => Math.max(1, Math.ceil((SAMPLE * 1e6) / ns));
  const nativeTimes = timesOf((await native.time(index, 3)).ns / 3);
  const timed = (way: (typeof WAYS)[number], times: number) => {
    let made = 0;
    const start = process.cpuUsage();
    for (let k = 0; k < times; k++) made += steppers[way]();
    const { user, system } = process.cpuUsage(start);
    const ns = 1000 * (user + system);
    if (made !== times * frames) throw new Error(`${scene.level.name}: expected ${times * frames} frames, made ${made}`);
    return ns;
  };
  const times = Object.fromEntries(
    WAYS.map((way) => {
      for (let k = 0; k < 4; k++) timed(way, timesOf(timed(way, 1)));
      return [way, timesOf(Math.min(timed(way, 1), timed(way, 1)))];
    }),
  );
  for (let round = 0; round < ROUNDS; round++) {
    const turn = async (k: number) => {
      if (k === WAYS.length) {
        const { ns, frames: made } = await native.time(index, nativeTimes);
        samples.native.push(ns / made);
        return;
      }
      const way = WAYS[k];
      samples[way].push(timed(way, times[way]) / (times[way] * frames));
    };
    for (let k = 0; k <= WAYS.length; k++) await turn((round + k) % (WAYS.length + 1));
  }
  return { samples, frames };
}

/** Where Linux says how much processor time the reading thread has used; the first number, in ns. */
const THREAD_TIME = '/proc/thread-self/schedstat';

/** Processor time of this thread, ms; the time of the clock where the system does not tell. */
function threadTime(): number {
  return existsSync(THREAD_TIME) ? Number(readFileSync(THREAD_TIME, 'utf8').split(' ')[0]) / 1e6 : performance.now();
}

/** A worker: plays all runs again and again for the requested time, and answers with frames per ms of its processor time. */
function work(scenes: readonly NativeScene[]): void {
  const steppers = scenes.map(({ level, runs }) => wholeRuns(createSimulation(compile(level, 'arcade')), runs));
  parentPort?.on('message', (window: number) => {
    let frames = 0;
    const until = performance.now() + window;
    const from = threadTime();
    for (let k = 0; performance.now() < until; k++) frames += steppers[k % steppers.length]();
    parentPort?.postMessage(frames / (threadTime() - from));
  });
}

/** Frames per ms of processor time, of one worker and of two at once, round by round. */
async function measureWorkers(scenes: readonly NativeScene[]): Promise<{ one: number[]; two: number[] }> {
  const workers = [0, 1].map(() => new Worker(new URL(import.meta.url), { workerData: scenes }));
  const play = (worker: Worker) =>
    new Promise<number>((resolve) => {
      worker.once('message', resolve);
      worker.postMessage(WINDOW);
    });
  const both = async () => sum(await Promise.all(workers.map(play)));
  await both();
  const one: number[] = [];
  const two: number[] = [];
  for (let round = 0; round < WORKER_ROUNDS; round++) {
    if (round % 2 === 0) one.push(await play(workers[round % 4 === 0 ? 0 : 1]));
    two.push(await both());
    if (round % 2 === 1) one.push(await play(workers[round % 4 === 1 ? 0 : 1]));
  }
  await Promise.all(workers.map((worker) => worker.terminate()));
  return { one, two };
}

export const bench = define({
  what: 'frames per second of arcade against a C++ loop (needs g++), and two workers against one',
  options: LEVELS,
  claims: {
    all: atLeast(0.7, 'throughput of arcade / of the C++ loop, all levels'),
    worst: atLeast(0.5, 'the same on the worst level'),
    workers: atLeast(1.8, 'throughput of two workers / of one'),
  },
  async run(asked) {
    const scenes = askedLevels(asked).map(({ level }, i) => sceneOf(level, i));
    const native = await startNative(join(PROJECT, 'bench/native.cpp'), scenes, MAX_FRAMES);
    const measured: { samples: Samples; frames: number }[] = [];
    try {
      assertSame(scenes, native);
      for (const [i, scene] of scenes.entries()) measured.push(await measureScene(scene, i, native));
    } finally {
      native.close();
    }
    const { one, two } = await measureWorkers(scenes);

    const times = measured.map(({ samples, frames }, i) => ({
      name: scenes[i].level.name,
      frames,
      native: median(samples.native),
      whole: median(samples.whole),
      frame: median(samples.frame),
      macro: median(samples.macro),
      ratio: median(samples.native.map((ns, k) => ns / samples.whole[k])),
    }));
    const total = (key: 'native' | (typeof WAYS)[number]) => sum(times.map((row) => row[key] * row.frames));
    const frames = sum(times.map((row) => row.frames));
    const overall = total('native') / total('whole');
    const worst = times.reduce((a, b) => (b.ratio < a.ratio ? b : a));
    const runs = sum(scenes.map((scene) => scene.runs.length));
    return {
      title: `Frames of arcade against a C++ loop (g++ -O2) on ${scenes.length} levels, ${runs} runs, ${frames} frames`,
      columns: ['', 'frames', 'C++, ns a frame', 'whole runs', 'frame by frame', `macros of ${MACRO}`, 'C++ / whole runs'],
      rows: [
        ...times.map((row) => Object.values(row)),
        ['all', frames, ...(['native', ...WAYS] as const).map((key) => total(key) / frames), overall],
      ],
      measured: { all: overall, worst: { [worst.name]: worst.ratio }, workers: median(two.map((rate, k) => rate / one[k])) },
      notes: [
        `Engine and C++ loop end each run in the same frame and bits. Medians of ${ROUNDS} interleaved rounds. Each level's own runs and ${SCRIPTS} random scripts.`,
        `A macro is restore, at most ${MACRO} frames, snapshot, with the runs of a level taking turns.`,
        `One worker makes ${(median(one) / 1000).toFixed(1)} million frames a second, two make ${(median(two) / 1000).toFixed(1)} million: each by ${existsSync(THREAD_TIME) ? 'the processor time of its thread, as if it had a core to itself' : 'the clock, so two need two idle cores'}.`,
      ],
    };
  },
});

if (!isMainThread) work(workerData as readonly NativeScene[]);
