import { type ChildProcess, spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import type { Circle, Hold, Level } from '../schema/index.ts';

/** A level with the scripts that are played on it; holds are sorted and disjoint. */
export interface NativeScene {
  readonly level: Level;
  readonly runs: readonly (readonly Hold[])[];
}

/** How a run ended in the C++ loop; outcome: 0 still going, 1 lost, 2 completed, 3 burned. */
export interface NativeEnd {
  readonly frames: number;
  readonly outcome: number;
  readonly minerals: number;
  /** x, y, vx, vy, cos, sin */
  readonly state: readonly number[];
}

/** `arcade.cpp` as a process: it plays on request and idles otherwise, so that it can take turns with the engine. */
export interface NativeArcade {
  /** The end of every run of every scene, in order. */
  readonly ends: readonly NativeEnd[];
  /** Plays all runs of a scene `times` times; returns its processor time in ns, and the number of frames. */
  time(scene: number, times: number): Promise<{ ns: number; frames: number }>;
  close(): void;
}

/** `-ffp-contract=off`: a fused multiply-add would be faster where available, and give other bits than JavaScript. */
const FLAGS = ['-std=c++17', '-O2', '-ffp-contract=off'];

const circles = (list: readonly Circle[]) => [list.length, ...list.flatMap(({ x, y, radius }) => [x, y, radius])];

/** The text that `readScene` in `arcade.cpp` reads. */
function sceneText({ level, runs }: NativeScene, maxFrames: number): string {
  const { astronaut, blackHole, range, recoil, asteroids, novae, repulsors, aliens, minerals, winds, wormholes } = level;
  const numbers = [
    ...[astronaut.x, astronaut.y, astronaut.vx, astronaut.vy, blackHole.x, blackHole.y, blackHole.radius, range, Number(recoil)],
    ...[asteroids.filter(({ hot }) => !hot), asteroids.filter(({ hot }) => hot), novae, repulsors, aliens, minerals].flatMap(
      circles,
    ),
    ...[winds.length, ...winds.flatMap(({ x, y, radius, ax, ay }) => [x, y, radius, ax, ay])],
    ...[wormholes.length, ...wormholes.flatMap(({ x, y, toX, toY, radius }) => [x, y, radius, toX, toY, radius])],
    ...[maxFrames, runs.length, ...runs.flatMap((holds) => [holds.length, ...holds.flat()])],
  ];
  return numbers.join(' ');
}

/**
 * Compiles `arcade.cpp` with g++ and loads the scenes into it.
 * @throws {Error} if there is no g++, or it does not compile
 */
export async function startNative(source: string, scenes: readonly NativeScene[], maxFrames: number): Promise<NativeArcade> {
  const folder = mkdtempSync(join(tmpdir(), 'gq-native-'));
  const binary = join(folder, 'arcade');
  const compiled = spawnSync('g++', [...FLAGS, '-o', binary, source], { encoding: 'utf8' });
  if (compiled.status !== 0) {
    rmSync(folder, { recursive: true });
    if (compiled.error !== undefined) {
      throw new Error(`expected g++ on the PATH to compile ${source}, found none (${compiled.error.message}): install GCC`);
    }
    throw new Error(`g++ ${FLAGS.join(' ')} refused ${source}:\n${compiled.stderr}`);
  }
  const child = spawn(binary, { stdio: ['pipe', 'pipe', 'ignore'] });
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  const next = async (): Promise<number[]> => {
    const { value, done } = await lines.next();
    if (done === true) throw new Error(`expected an answer of ${binary}, found its end`);
    return value.split(' ').map(Number);
  };
  send(child, `${scenes.length}\n${scenes.map((scene) => sceneText(scene, maxFrames)).join('\n')}\ncheck\n`);
  const ends: NativeEnd[] = [];
  for (const { runs } of scenes) {
    for (const _ of runs) {
      const [frames, outcome, minerals, ...state] = await next();
      ends.push({ frames, outcome, minerals, state });
    }
  }
  return {
    ends,
    async time(scene, times) {
      send(child, `time ${scene} ${times}\n`);
      const [ns, frames] = await next();
      return { ns, frames };
    },
    close() {
      child.kill();
      rmSync(folder, { recursive: true });
    },
  };
}

function send(child: ChildProcess, text: string): void {
  child.stdin?.write(text);
}
