import {
  ACCURACIES,
  type Accuracy,
  type AccuracyName,
  compile,
  createSimulation,
  DEFAULT_ACCURACY,
  joinHolds,
  playScript,
  TICK,
  TICK_RATE,
} from '../engine/index.ts';
import { type BenchScene, ORBIT, TWELVE_CIRCLES } from '../tests/scenes/index.ts';
import { atMost, type Contestant, compare, publish } from './harness.ts';
import { buttonPerStep, loadPeers, type Peer, type PeerWorld, simulatePeer } from './peers/index.ts';
import { referenceEnd } from './reference.ts';

const PEER_RATE = 60;
const REFERENCE_RATE = 3840;

interface Method {
  readonly name: string;
  readonly contestant: Contestant;
  /** Simulated time of one run of the contestant, s. */
  readonly seconds: number;
  /** Her place at the end of a scene, px; null if the run ended before. */
  end(scene: BenchScene): readonly [x: number, y: number] | null;
  readonly note: string;
}

function ours(name: AccuracyName): Method {
  const { level, holds, seconds } = TWELVE_CIRCLES;
  const accuracy: Accuracy = ACCURACIES[name];
  const simulation = createSimulation(compile(level, accuracy));
  const script = joinHolds(holds);
  const state = new Float64Array(6);
  const run = () => {
    simulation.reset();
    playScript(simulation, script, seconds * TICK_RATE);
    simulation.readState(state);
    return state[0] + state[1];
  };
  run();
  return {
    name,
    contestant: { name, run },
    seconds: simulation.ending?.time ?? simulation.tick * TICK,
    note: accuracy.contact === 'swept' ? 'contacts swept' : 'contacts once a step',
    end(scene) {
      const other = createSimulation(compile(scene.level, accuracy));
      playScript(other, joinHolds(scene.holds), scene.seconds * TICK_RATE);
      other.readState(state);
      return other.ending === null ? [state[0], state[1]] : null;
    },
  };
}

function theirs(peer: Peer): Method {
  const { level, holds, seconds } = TWELVE_CIRCLES;
  const steps = seconds * PEER_RATE;
  const button = buttonPerStep(holds, steps, PEER_RATE);
  const state = new Float64Array(4);
  let world: PeerWorld = peer.create(level, PEER_RATE);
  return {
    name: peer.name,
    seconds,
    contestant: {
      name: peer.name,
      prepare() {
        world.dispose();
        world = peer.create(level, PEER_RATE);
      },
      run() {
        for (let i = 0; i < steps; i++) world.step(button[i] === 1);
        world.read(state);
        return state[0] + state[1];
      },
    },
    note: `${PEER_RATE} Hz, ${peer.precision} precision, contacts once a step`,
    end(scene) {
      const run = simulatePeer(peer, scene.level, scene.holds, scene.seconds, PEER_RATE);
      const [, x, y] = run.samples[run.samples.length - 1];
      return run.outcome === null ? [x, y] : null;
    },
  };
}

const peers = await loadPeers();
const methods = [...(Object.keys(ACCURACIES) as AccuracyName[]).map(ours), ...peers.map(theirs)];

const scenes = [ORBIT, TWELVE_CIRCLES];
const references = scenes.map((scene) => referenceEnd(scene.level, scene.holds, scene.seconds, REFERENCE_RATE));
const doubts = scenes.map((scene, i) => {
  const coarser = referenceEnd(scene.level, scene.holds, scene.seconds, REFERENCE_RATE / 2);
  return Math.hypot(coarser[0] - references[i][0], coarser[1] - references[i][1]);
});
const errors = methods.map((method) =>
  scenes.map((scene, i) => {
    const end = method.end(scene);
    return end === null ? null : Math.hypot(end[0] - references[i][0], end[1] - references[i][1]);
  }),
);

const measured = compare(
  methods.map((method) => method.contestant),
  { rounds: 21, sampleMs: 8, warmUpMs: 500 },
);
const seconds = Object.fromEntries(methods.map((method) => [method.name, method.seconds]));
/** Cost per simulated second of `a` divided by that of `b`. */
const ratio = (a: string, b: string): number => (measured.ratio(a, b).median * seconds[b]) / seconds[a];

const mine = DEFAULT_ACCURACY;
const [phaser, p2] = peers;
const orbitError = (name: string): number => errors[methods.findIndex((method) => method.name === name)][0] ?? Number.NaN;
publish({
  title: `Cost of a moving astronaut among 12 circles, and error after a minute (${TWELVE_CIRCLES.what})`,
  columns: ['', 'us a simulated second', `times ${mine}`, 'error px, orbit', 'error px, twelve circles', ''],
  rows: methods.map((method, i) => [
    method.name,
    (1000 * measured.time(method.name).median) / method.seconds,
    ratio(method.name, mine),
    ...errors[i],
    method.note,
  ]),
  claims: [
    atMost(`cost of ${mine} / ${phaser.name}`, ratio(mine, phaser.name), 0.1),
    atMost(`cost of ${mine} / ${p2.name}`, ratio(mine, p2.name), 0.1),
    atMost(`cost of ${mine} / fast`, ratio(mine, 'fast'), 1),
    atMost(`orbit error of ${mine} / ${phaser.name}`, orbitError(mine) / orbitError(phaser.name), 1e-3),
    atMost(`orbit error of ${mine} / ${p2.name}`, orbitError(mine) / orbitError(p2.name), 1e-3),
  ],
  notes: [
    `Medians of ${measured.rounds} interleaved rounds; worlds are made outside the timing. '-': the run ended in a contact before its minute.`,
    `Errors against Runge-Kutta 4 at ${REFERENCE_RATE} Hz with target changes located; half its rate moves it by ` +
      scenes.map((scene, i) => `${doubts[i].toExponential(1)} px (${scene.name})`).join(' and ') +
      '. arcade answers a press one frame late, as the original did: most of its error is that.',
  ],
});
