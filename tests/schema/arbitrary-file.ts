import fc from 'fast-check';
import {
  type Field,
  fieldsOf,
  isRequired,
  KINDS,
  type LevelFile,
  LIMITS,
  LISTED_KINDS,
  NOTE_TEXT,
  notesInOrder,
  OBJECT_LISTS,
  type ObjectKind,
  SINGLE_KINDS,
} from '../../schema/index.ts';

const id = fc.option(fc.stringMatching(/^[a-z0-9]{2,16}$/), { nil: undefined });

/** The value of an x- key: anything. */
const extension = fc.dictionary(
  fc.string().map((key) => `x-${key}`),
  fc.jsonValue({ maxDepth: 3 }),
  { maxKeys: 2 },
);

const withExtensions = <T extends object>(object: fc.Arbitrary<T>): fc.Arbitrary<T> =>
  fc.tuple(object, extension).map(([known, own]) => ({ ...known, ...own }));

const anyValue = (field: Field): fc.Arbitrary<unknown> =>
  field.type === 'flag' ? fc.boolean() : fc.double({ min: field.least, max: field.most, noNaN: true });

/** Any object of a kind. */
const objectOf = (kind: ObjectKind) => {
  const fields = Object.fromEntries(fieldsOf(kind).map(([name, field]) => [name, anyValue(field)]));
  const requiredKeys = fieldsOf(kind).flatMap(([name, field]) => (isRequired(field) ? [name] : []));
  return withExtensions(
    fc.record({ ...(KINDS[kind].list === null ? {} : { id }), ...fields } as Record<string, fc.Arbitrary<unknown>>, {
      requiredKeys,
    }),
  );
};

const hold = fc
  .tuple(fc.nat(LIMITS.tick - 1), fc.nat(LIMITS.tick))
  .map(([press, more]): [number, number] => [press, Math.min(LIMITS.tick, press + 1 + more)]);

const note = withExtensions(
  fc.record({
    tick: fc.nat(LIMITS.tick),
    text: fc
      .oneof(fc.string({ minLength: 1 }), fc.string({ minLength: 1, unit: 'binary' }))
      .filter((text) => NOTE_TEXT.test(text)),
  }),
);

const run = withExtensions(
  fc.record(
    {
      name: fc.string({ minLength: 1, maxLength: 80 }),
      holds: fc.array(hold, { maxLength: 5 }),
      notes: fc.array(note, { maxLength: 4 }).map(notesInOrder),
    },
    { requiredKeys: ['name', 'holds'] },
  ),
);

const list = <T>(entry: fc.Arbitrary<T>) => fc.array(entry, { maxLength: 5 });

const file = withExtensions(
  fc.record(
    {
      $schema: fc.string(),
      version: fc.constant(1 as const),
      name: fc.string({ minLength: 1, maxLength: 120, unit: 'binary' }).filter((name) => name.length <= 120),
      description: fc.string(),
      ...Object.fromEntries(SINGLE_KINDS.map((kind) => [kind, objectOf(kind)])),
      range: fc.double({ min: LIMITS.leastRadius, max: LIMITS.radius, noNaN: true }),
      recoil: fc.boolean(),
      ...Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, list(objectOf(kind))])),
      runs: fc.uniqueArray(run, { maxLength: 3, selector: ({ name }) => name }),
    },
    { requiredKeys: ['version', 'name', ...SINGLE_KINDS] as never },
  ),
);

function withoutRepeatedIds(level: LevelFile): LevelFile {
  const seen = new Set<string>();
  for (const list of OBJECT_LISTS) {
    for (const object of level[list] ?? []) {
      if (object.id !== undefined && seen.has(object.id)) delete object.id;
      else if (object.id !== undefined) seen.add(object.id);
    }
  }
  return level;
}

/** Any valid level file: with missing keys, values at limits, and x- keys everywhere. */
export const arbitraryFile: fc.Arbitrary<LevelFile> = file.map((level) => withoutRepeatedIds(level as unknown as LevelFile));
