import fc from 'fast-check';
import { type LevelFile, LIMITS } from '../../schema/index.ts';

const within = (limit: number) => fc.double({ min: -limit, max: limit, noNaN: true });
const radius = fc.double({ min: LIMITS.leastRadius, max: LIMITS.radius, noNaN: true });
const id = fc.option(fc.stringMatching(/^[a-z0-9]{2,16}$/), { nil: undefined });
const place = { id, x: within(LIMITS.coordinate), y: within(LIMITS.coordinate) };

/** What stands under keys of one's own: anything. */
const extension = fc.dictionary(
  fc.string().map((key) => `x-${key}`),
  fc.jsonValue({ maxDepth: 3 }),
  { maxKeys: 2 },
);

const withExtensions = <T extends object>(object: fc.Arbitrary<T>): fc.Arbitrary<T> =>
  fc.tuple(object, extension).map(([known, own]) => ({ ...known, ...own }));

const sized = withExtensions(fc.record({ ...place, radius }, { requiredKeys: ['x', 'y', 'radius'] }));
const sizable = withExtensions(fc.record({ ...place, radius }, { requiredKeys: ['x', 'y'] }));
const asteroid = withExtensions(fc.record({ ...place, radius, hot: fc.boolean() }, { requiredKeys: ['x', 'y', 'radius'] }));

const hold = fc
  .tuple(fc.nat(LIMITS.tick - 1), fc.nat(LIMITS.tick))
  .map(([press, more]): [number, number] => [press, Math.min(LIMITS.tick, press + 1 + more)]);

const run = withExtensions(
  fc.record({ name: fc.string({ minLength: 1, maxLength: 80 }), holds: fc.array(hold, { maxLength: 5 }) }),
);

const list = <T>(entry: fc.Arbitrary<T>) => fc.array(entry, { maxLength: 5 });

const file = withExtensions(
  fc.record(
    {
      $schema: fc.string(),
      version: fc.constant(1 as const),
      name: fc.string({ minLength: 1, maxLength: 120, unit: 'binary' }).filter((name) => name.length <= 120),
      description: fc.string(),
      astronaut: withExtensions(
        fc.record(
          { x: place.x, y: place.y, vx: within(LIMITS.velocity), vy: within(LIMITS.velocity) },
          { requiredKeys: ['x', 'y'] },
        ),
      ),
      blackHole: withExtensions(fc.record({ x: place.x, y: place.y, radius }, { requiredKeys: ['x', 'y'] })),
      range: radius,
      recoil: fc.boolean(),
      asteroids: list(asteroid),
      novae: list(sized),
      repulsors: list(sized),
      aliens: list(sizable),
      minerals: list(sizable),
      runs: fc.uniqueArray(run, { maxLength: 3, selector: ({ name }) => name }),
    },
    { requiredKeys: ['version', 'name', 'astronaut', 'blackHole'] },
  ),
);

function withoutRepeatedIds(level: LevelFile): LevelFile {
  const seen = new Set<string>();
  for (const objects of [level.asteroids, level.novae, level.repulsors, level.aliens, level.minerals]) {
    for (const object of objects ?? []) {
      if (object.id !== undefined && seen.has(object.id)) delete object.id;
      else if (object.id !== undefined) seen.add(object.id);
    }
  }
  return level;
}

/** Any valid level file: any keys left out, any limits reached, keys of one's own everywhere. */
export const arbitraryFile: fc.Arbitrary<LevelFile> = file.map((level) => withoutRepeatedIds(level as LevelFile));
