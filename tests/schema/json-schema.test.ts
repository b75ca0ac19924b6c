import { describe, expect, test } from 'vitest';
import { formatLevelJsonSchema, levelJsonSchema, levelSchema, OBJECT_KINDS } from '../../schema/index.ts';

interface Node {
  readonly type?: string;
  readonly description?: string;
  readonly properties?: Record<string, Node>;
  readonly items?: Node;
  readonly additionalProperties?: unknown;
  readonly patternProperties?: unknown;
  readonly required?: string[];
}

const root = levelJsonSchema() as Node & { readonly $schema: string };

function* objectsIn(node: Node): Generator<Node> {
  if (node.type === 'object') yield node;
  for (const inner of [...Object.values(node.properties ?? {}), ...(node.items ? [node.items] : [])]) yield* objectsIn(inner);
}

describe('the JSON Schema of a level', () => {
  test('is the committed file (updated by vitest -u)', async () => {
    await expect(formatLevelJsonSchema()).toMatchFileSnapshot('../../schema/level.schema.json');
  });

  test('is draft 2020-12 and requires what the format requires', () => {
    expect(root.$schema).toBe('https://json-schema.org/draft/2020-12/schema');
    expect(root.required).toEqual(['version', 'name', 'astronaut', 'blackHole']);
    expect(Object.keys(root.properties ?? {})).toEqual(Object.keys(levelSchema.shape));
  });

  test('allows x- keys in every object, and no other unknown key', () => {
    const objects = [...objectsIn(root)];
    // the level, a conflict, its rules, what it allows, its kinds of objects, and a run
    expect(objects).toHaveLength(6 + OBJECT_KINDS.length);
    for (const object of objects) {
      expect(object.additionalProperties).toBe(false);
      expect(object.patternProperties).toEqual({ '^x-': {} });
    }
  });

  test('describes every number and object, as the editor shows these texts', () => {
    for (const object of objectsIn(root)) {
      expect(object.description).toMatch(/\.$/);
      for (const [key, property] of Object.entries(object.properties ?? {}))
        expect(`${key}: ${property.description}`).toMatch(/\.$/);
    }
  });
});
