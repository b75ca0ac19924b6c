import { compile, createSimulation, joinHolds, playScript, type Simulation } from '../engine/index.ts';
import { TWELVE_CIRCLES } from '../tests/scenes/index.ts';
import { atMost, compare, publish } from './harness.ts';
import { buttonPerStep } from './peers/index.ts';
import { phaserArcade } from './peers/phaser-arcade.ts';
import { type PlainState, plainLoop, plainScene } from './plain-loop.ts';

const { level, holds, seconds } = TWELVE_CIRCLES;
const TICKS = seconds * 60;

/** The engine as a search or a playtest steps it: reset, then the script to its end. */
const simulation: Simulation = createSimulation(compile(level, 'arcade'));
const script = joinHolds(holds);
const state = new Float64Array(6);

function playEngine(): number {
  simulation.reset();
  playScript(simulation, script, TICKS);
  simulation.readState(state);
  return state[0] + state[1];
}

const plain = plainScene(level, holds);
const out: PlainState = { frame: 0, outcome: 0, x: 0, y: 0, vx: 0, vy: 0, cos: 0, sin: 0 };

function playPlain(): number {
  plainLoop(plain, TICKS, out);
  return out.x + out.y;
}

// the loop is a fair yardstick only if it does the same work: the same frames, the same bits
playEngine();
playPlain();
const [x, y, vx, vy, cos, sin] = state;
const different = Object.entries({ frame: simulation.tick, outcome: 0, x, y, vx, vy, cos, sin }).filter(
  ([key, value]) => !Object.is(value, out[key as keyof PlainState]),
);
if (different.length > 0 || simulation.ending !== null) {
  throw new Error(
    `the plain loop and the engine disagree in ${different.map(([key]) => key).join(', ') || 'nothing, but the run ended'}`,
  );
}

await phaserArcade.load();
const button = buttonPerStep(holds, TICKS, 60);
const peerState = new Float64Array(4);

let world = phaserArcade.create(level, 60);

function preparePhaser(): void {
  world.dispose();
  world = phaserArcade.create(level, 60);
}

function playPhaser(): number {
  for (let i = 0; i < TICKS; i++) world.step(button[i] === 1);
  world.read(peerState);
  return peerState[0] + peerState[1];
}

const names = { engine: 'arcade', plain: 'plain loop', phaser: phaserArcade.name };
const measured = compare(
  [
    { name: names.engine, run: playEngine },
    { name: names.plain, run: playPlain },
    { name: names.phaser, run: playPhaser, prepare: preparePhaser },
  ],
  { rounds: 51, sampleMs: 12, warmUpMs: 800 },
);

publish({
  title: `One minute of play: ${TWELVE_CIRCLES.what}`,
  columns: ['', 'ms a minute', 'quartiles', 'us a simulated second', 'times the plain loop'],
  rows: Object.values(names).map((name) => {
    const { median, q1, q3 } = measured.time(name);
    return [
      name,
      median,
      `${q1.toFixed(3)} - ${q3.toFixed(3)}`,
      (1000 * median) / seconds,
      measured.ratio(name, names.plain).median,
    ];
  }),
  claims: [
    atMost('arcade / plain loop', measured.ratio(names.engine, names.plain).median, 1.3),
    atMost(`arcade / ${names.phaser}`, measured.ratio(names.engine, names.phaser).median, 1 / 5),
  ],
  notes: [`Medians of ${measured.rounds} interleaved rounds. Engine and plain loop end in the same bits.`],
});
