import { getHeapStatistics } from 'node:v8';
import { type AccuracyName, compile, createSimulation, joinHolds, type RunEvent, STATE_SIZE } from '../engine/index.ts';
import { createPlayer } from '../game/index.ts';
import {
  ACCURACY_NAMES,
  askedLevels,
  atMost,
  compare,
  consume,
  define,
  LEVELS,
  median,
  type NamedLevel,
} from './harness/index.ts';

const TICK = 1000 / 60;
/** Most that the player may cost above the engine, ns a tick: a thousandth of a percent of a frame at 60 Hz is 167. */
const OVERHEAD = 200;
/** Frames before the heap is measured, and over which it is: so few that no garbage is collected meanwhile, but often. */
const WARM_UP = 20_000;
const FRAMES = 500;
const ROUNDS = 41;

/** Every run once, a tick a frame. */
const cases = (levels: readonly NamedLevel[], accuracy: AccuracyName) =>
  levels.map(({ level }) => ({ scene: compile(level, accuracy), holds: joinHolds(level.runs[0].holds) }));

/** The engine alone: a tick at a time, the gun as the holds say, and after each all is read that moves, as a game draws it. */
function bare(all: ReturnType<typeof cases>): () => number {
  const state = new Float64Array(STATE_SIZE);
  const runs = all.map(({ scene, holds }) => {
    const events: RunEvent[] = [];
    const { level } = scene;
    const aliens = new Float64Array(3 * level.aliens.length);
    const asteroids = new Float64Array(level.recoil ? 2 * level.asteroids.length : 0);
    return { simulation: createSimulation(scene, undefined, events), events, holds, aliens, asteroids };
  });
  return () => {
    let ticks = 0;
    for (const { simulation, events, holds, aliens, asteroids } of runs) {
      simulation.reset();
      events.length = 0;
      let next = 0;
      while (simulation.ending === null) {
        const { tick } = simulation;
        while (next < holds.length && holds[next][1] <= tick) next++;
        simulation.advance(1, next < holds.length && holds[next][0] <= tick);
        simulation.readState(state);
        if (aliens.length > 0 && simulation.mayAliensHaveStirred) simulation.readAliens(aliens);
        if (asteroids.length > 0) simulation.readAsteroids(asteroids);
        ticks++;
      }
      consume(state[0]);
    }
    return ticks;
  };
}

/** The same by a player, in frames of a tick. */
function played(all: ReturnType<typeof cases>): () => number {
  const players = all.map(({ scene, holds }) => createPlayer(scene, { replay: holds, maxTime: 3600 }));
  return () => {
    let ticks = 0;
    for (const player of players) {
      player.restart();
      while (player.ending === null) ticks += player.advance(TICK);
      consume(player.state[0]);
    }
    return ticks;
  };
}

/** Bytes that a call of `frame` leaves on the heap: the median over some rounds, since garbage is collected in a few. */
function bytesOf(frame: () => void): number {
  for (let i = 0; i < WARM_UP; i++) frame();
  const growths = Array.from({ length: ROUNDS }, () => {
    const before = getHeapStatistics().used_heap_size;
    for (let i = 0; i < FRAMES; i++) frame();
    return (getHeapStatistics().used_heap_size - before) / FRAMES;
  });
  return median(growths);
}

/** Bytes a tick of the engine, and a frame of a player that draws, while nothing happens: she drifts. */
function bytesAFrame({ level }: NamedLevel, accuracy: AccuracyName): { engine: number; player: number } {
  const lonely = { ...level, blackHole: { ...level.blackHole, x: 1e8, y: 1e8 }, range: 1e6, novae: [], aliens: [] };
  const scene = compile(lonely, accuracy);
  const state = new Float64Array(STATE_SIZE);
  const simulation = createSimulation(scene, undefined, []);
  const player = createPlayer(scene, { maxTime: 3600 });
  const engine = bytesOf(() => {
    simulation.advance(1, false);
    simulation.readState(state);
  });
  const ofPlayer = bytesOf(() => {
    player.advance(TICK);
    player.readPose(state);
  });
  consume(state[0] + player.tick);
  if (player.ending !== null) throw new Error(`expected a play that goes on, found ${player.ending.outcome} at ${player.tick}`);
  return { engine, player: ofPlayer };
}

export const bench = define({
  what: 'what a player costs above the engine, in time and in memory',
  options: LEVELS,
  claims: {
    time: atMost(OVERHEAD, 'ns a tick that the player adds'),
    bytes: atMost(2, 'bytes a frame that the player adds'),
  },
  flags: ['--expose-gc', '--max-semi-space-size=64'],
  run(asked) {
    const levels = askedLevels(asked).filter(({ level }) => level.runs.length > 0);
    const time: Record<string, number> = {};
    const added: Record<string, number> = {};
    const rows = ACCURACY_NAMES.map((accuracy) => {
      const all = cases(levels, accuracy);
      const bareRun = bare(all);
      const playedRun = played(all);
      const ticks = bareRun();
      if (playedRun() !== ticks) throw new Error('expected the same ticks of the player and of the engine');
      const measured = compare(
        [
          { name: 'engine', run: bareRun },
          { name: 'player', run: playedRun },
        ],
        { rounds: 31, sampleMs: 40, warmUpMs: 800 },
      );
      const { median: ratio, q1, q3 } = measured.ratio('player', 'engine');
      const bytes = bytesAFrame(levels[0], accuracy);
      const nanoseconds = (name: string) => (measured.time(name).median * 1e6) / ticks;
      time[accuracy] = nanoseconds('engine') * (ratio - 1);
      added[accuracy] = bytes.player - bytes.engine;
      return [accuracy, nanoseconds('engine'), nanoseconds('player'), ratio, q1, q3, bytes.engine, bytes.player];
    });
    return {
      title: `What a player costs above the engine, on the first runs of ${levels.length} levels, a tick a frame`,
      columns: [
        ...['accuracy', 'engine, ns a tick', 'player, ns a tick', 'ratio: median', 'quartile', 'quartile'],
        ...['engine, bytes a tick', 'player, bytes a frame'],
      ],
      rows,
      measured: { time, bytes: added },
      notes: [
        'The engine is advanced by a tick with events, and what moves is read; the player also keeps both states, the edges and the hash.',
        `Bytes: growth of the heap over ${FRAMES} frames of a play in which nothing happens, the median of ${ROUNDS} times.`,
      ],
    };
  },
});
