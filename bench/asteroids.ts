import { compile } from '../engine/index.ts';
import { asteroidField } from '../tests/scenes/index.ts';
import { ACCURACY_NAMES, atMost, compare, define } from './harness/index.ts';
import { lasting } from './replayer.ts';

const FEW = asteroidField(100);
const MANY = asteroidField(10_000);
/** How far apart she may end in the two fields, px: rounding, not a different path. */
const SAME = 1e-6;

export const bench = define({
  what: '10,000 asteroids against 100',
  options: {},
  claims: { ratio: atMost(3, `cost of ${MANY.name} / of ${FEW.name}`) },
  run() {
    const ratios: Record<string, number> = {};
    const rows = ACCURACY_NAMES.map((name) => {
      const contestants = [FEW, MANY].map((scene) => ({
        name: scene.name,
        run: lasting(scene, name, `${scene.name} at ${name}`).run,
      }));
      // the larger field only adds asteroids farther out, so her path must be the same
      const [few, many] = contestants.map((contestant) => contestant.run());
      if (Math.abs(few - many) > SAME) throw new Error(`${name}: ${FEW.name} and ${MANY.name} end in different places`);

      const measured = compare(contestants, { rounds: 21, sampleMs: 4, warmUpMs: 300 });
      ratios[name] = measured.ratio(MANY.name, FEW.name).median;
      const compiling = performance.now();
      compile(MANY.level, name);
      const compiled = performance.now() - compiling;
      const cost = ({ name: of, seconds }: typeof FEW) => (1000 * measured.time(of).median) / seconds;
      return [name, cost(FEW), cost(MANY), ratios[name], compiled];
    });
    return {
      title: `Cost of many asteroids: ${MANY.what}, against ${FEW.name} of them`,
      columns: ['accuracy', `us a simulated second, ${FEW.name}`, `${MANY.name}`, 'ratio', `ms to compile ${MANY.name}`],
      rows,
      measured: { ratio: ratios },
      notes: [
        'She flies the same way in both: the larger field has the smaller one in its middle. Medians of 21 interleaved rounds.',
      ],
    };
  },
});
