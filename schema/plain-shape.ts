import { levelJsonSchema } from './json-schema.ts';
import { fieldsOf, KINDS, OBJECT_KINDS, OBJECT_LISTS } from './kinds.ts';
import { DEFAULT_RANGE } from './level-constants.ts';
import type { Shape } from './plain/index.ts';

interface JsonSchema {
  readonly type?: NonNullable<Shape['type']>;
  readonly minimum?: number;
  readonly maximum?: number;
  readonly minLength?: number;
  readonly maxLength?: number;
  readonly maxItems?: number;
  readonly pattern?: string;
  readonly const?: unknown;
  readonly items?: JsonSchema;
  readonly prefixItems?: readonly JsonSchema[];
  readonly properties?: Readonly<Record<string, JsonSchema>>;
  readonly required?: readonly string[];
}

type Values = Readonly<Record<string, unknown>>;

/** What a level has where its file leaves a key out. */
const USUAL: Values = {
  description: '',
  range: DEFAULT_RANGE,
  recoil: false,
  ...Object.fromEntries([...OBJECT_LISTS, 'runs'].map((list) => [list, []])),
};

/** What an object has where a file leaves a key out, by the key of the object or its list. */
const USUAL_IN: Readonly<Record<string, Values>> = Object.fromEntries(
  OBJECT_KINDS.map((kind) => [
    KINDS[kind].list ?? kind,
    { id: null, ...Object.fromEntries(fieldsOf(kind).map(([name, field]) => [name, field.default])) },
  ]),
);

function toShape(schema: JsonSchema, usual: Values, usualIn: typeof USUAL_IN): Shape {
  const { type, properties, required = [], prefixItems } = schema;
  // a hold: its two ticks are alike
  const each = prefixItems?.[0] ?? schema.items;
  const least = prefixItems?.length ?? schema.minimum ?? schema.minLength;
  const most = prefixItems?.length ?? schema.maximum ?? schema.maxLength ?? schema.maxItems;
  const shapeOf = (key: string, value: JsonSchema): Shape => ({
    ...toShape(value, usualIn[key] ?? {}, {}),
    ...(required.includes(key) ? {} : { optional: true, usual: usual[key] }),
  });
  return {
    type,
    least,
    most,
    only: schema.const,
    pattern: schema.pattern,
    each: each && toShape(each, usual, {}),
    keys: properties && Object.fromEntries(Object.entries(properties).map(([key, value]) => [key, shapeOf(key, value)])),
  };
}

/**
 * The text of `plain/level-shape.ts`: the shape of a level file as its JSON Schema has it, without words, and with the values
 * that `resolveLevel` fills in.
 *
 * @returns the source of a module
 */
export function formatLevelShape(): string {
  const shape = toShape(levelJsonSchema() as JsonSchema, USUAL, USUAL_IN);
  const text = JSON.stringify(shape, null, 1).replace(/"(\w+|\$schema)":/g, '$1:');
  return `import type { Shape } from './shape.ts';

// Made from the schema of level files by \`npx vitest run tests/schema/plain.test.ts --update\`: not to be edited.
/** The shape of a level file. */
export const LEVEL_SHAPE: Shape = ${text};
`;
}
