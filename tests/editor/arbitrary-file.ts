import fc from 'fast-check';
import {
  fieldsOf,
  formatLevel,
  isRequired,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  type ObjectKind,
  RULE_NAMES,
  RULES,
  readLevel,
  SINGLE_KINDS,
  withIds,
} from '../../schema/index.ts';

const coordinate = fc.oneof(
  { weight: 4, arbitrary: fc.integer({ min: -500, max: 500 }) },
  { weight: 1, arbitrary: fc.double({ min: -1e9, max: 1e9, noNaN: true }).map((x) => x + 0) },
);
const radius = fc.oneof(fc.constantFrom(7, 16, 25, 32, 48), fc.double({ min: 1e-3, max: 1e6, noNaN: true }));
const optional = <T>(arbitrary: fc.Arbitrary<T>) => fc.option(arbitrary, { nil: undefined });
const own = optional(fc.record({ note: fc.string(), list: fc.array(fc.integer(), { maxLength: 3 }) }));

/** The fields of an object of a kind. */
const fields = (kind: ObjectKind): Record<string, fc.Arbitrary<unknown>> => {
  const { places, radius: radiusField } = KINDS[kind];
  return Object.fromEntries(
    fieldsOf(kind).map(([name, field]) => {
      if (places.flat().includes(name)) return [name, coordinate];
      const value: fc.Arbitrary<unknown> =
        name === radiusField
          ? radius
          : field.type === 'flag'
            ? fc.boolean()
            : fc.integer({ min: Math.ceil(field.least), max: Math.floor(field.most) });
      return [name, isRequired(field) ? value : optional(value)];
    }),
  );
};

const list = (kind: ObjectKind) => optional(fc.array(fc.record({ ...fields(kind), 'x-own': own }), { maxLength: 4 }));

const holds = fc.array(
  fc.tuple(fc.nat(800), fc.integer({ min: 1, max: 120 })).map(([press, length]): [number, number] => [press, press + length]),
  { maxLength: 5 },
);

const notes = fc.array(
  fc.record({ tick: fc.nat(900), text: fc.constantFrom('first swing', 'again', '# hash', 'é "quoted"'), 'x-own': own }),
  { maxLength: 4 },
);

const runs = optional(
  fc.uniqueArray(
    fc.record({
      name: fc.constantFrom('solution', 'short', 'all minerals', 'fails', 'é "quoted"'),
      holds,
      notes: optional(notes),
    }),
    { selector: ({ name }) => name, maxLength: 4 },
  ),
);

const rules = optional(
  fc.record({
    ...Object.fromEntries(
      RULE_NAMES.map((name) => [
        name,
        optional(fc.double({ min: RULES[name].least, max: RULES[name].most, noNaN: true }).map((x) => x + 0)),
      ]),
    ),
    'x-own': own,
  }),
);

const file = fc.record({
  version: fc.constant(1 as const),
  name: fc.constantFrom('Level', 'Slingshot', '名前', 'a "b"'),
  description: optional(fc.string({ maxLength: 30 })),
  ...Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, fc.record(fields(kind))])),
  range: optional(radius),
  recoil: optional(fc.boolean()),
  rules,
  ...Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, list(kind)])),
  runs,
  'x-mine': own,
});

/** Any small valid level file as the editor opens it: with an id on every object, x- keys, and missing or empty lists. */
export const arbitraryFile: fc.Arbitrary<LevelFile> = file.map((value) => {
  const reading = readLevel(formatLevel(value as unknown as LevelFile));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  return withIds(reading.document.file);
});
