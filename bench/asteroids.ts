import { ACCURACIES, type AccuracyName, compile, createSimulation, joinHolds, playScript, TICK_RATE } from '../engine/index.ts';
import { asteroidField } from '../tests/scenes/index.ts';
import { atMost, type Claim, compare, publish } from './harness.ts';

const FEW = asteroidField(100);
const MANY = asteroidField(10_000);
const LIMIT = 3;
/** How far apart she may end in the two fields, px: rounding, not a different path. */
const SAME = 1e-6;

const rows: (string | number)[][] = [];
const claims: Claim[] = [];
for (const name of Object.keys(ACCURACIES) as AccuracyName[]) {
  const state = new Float64Array(6);
  const contestants = [FEW, MANY].map((scene) => {
    const simulation = createSimulation(compile(scene.level, name));
    const script = joinHolds(scene.holds);
    return {
      name: scene.name,
      run() {
        simulation.reset();
        playScript(simulation, script, scene.seconds * TICK_RATE);
        simulation.readState(state);
        if (simulation.ending !== null) throw new Error(`${scene.name}: the run ended (${simulation.ending.outcome})`);
        return state[0] + state[1];
      },
    };
  });
  // the larger field only adds asteroids farther out, so her path must be the same
  const [few, many] = contestants.map((contestant) => contestant.run());
  if (Math.abs(few - many) > SAME) throw new Error(`${name}: ${FEW.name} and ${MANY.name} end in different places`);

  const measured = compare(contestants, { rounds: 21, sampleMs: 4, warmUpMs: 300 });
  const ratio = measured.ratio(MANY.name, FEW.name).median;
  const compiling = performance.now();
  compile(MANY.level, name);
  rows.push([
    name,
    (1000 * measured.time(FEW.name).median) / FEW.seconds,
    (1000 * measured.time(MANY.name).median) / MANY.seconds,
    ratio,
    performance.now() - compiling,
  ]);
  claims.push(atMost(`${name}: ${MANY.name} / ${FEW.name}`, ratio, LIMIT));
}

publish({
  title: `Cost of many asteroids: ${MANY.what}, against ${FEW.name} of them`,
  columns: ['accuracy', `us a simulated second, ${FEW.name}`, `${MANY.name}`, 'ratio', `ms to compile ${MANY.name}`],
  rows,
  claims,
  notes: [
    'She flies the same way in both: the larger field has the smaller one in its middle. Medians of 21 interleaved rounds.',
  ],
});
