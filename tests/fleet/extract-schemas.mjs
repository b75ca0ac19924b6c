// Makes the schemas in fixtures/schemas/ of published packages; README.md there has the commands.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { gunzipSync } from 'node:zlib';

const [unpacked] = process.argv.slice(2);
if (unpacked === undefined) {
  console.error('expected the folder of the unpacked wheels, found nothing: node tests/fleet/extract-schemas.mjs FOLDER');
  process.exit(2);
}
const from = (path) => join(unpacked, path);
const write = (name, schema) =>
  writeFileSync(join(import.meta.dirname, 'fixtures/schemas', name), `${JSON.stringify(schema, null, 1)}\n`);

/** The definitions that some need, and those that these need. */
function closure(definitions, roots) {
  const needed = new Map();
  const add = (name) => {
    if (needed.has(name)) return;
    needed.set(name, definitions[name]);
    for (const [, next] of JSON.stringify(definitions[name]).matchAll(/"#\/\$defs\/([^"]+)"/g)) add(next);
  };
  for (const root of roots) add(root);
  return Object.fromEntries([...needed].sort(([a], [b]) => (a < b ? -1 : 1)));
}

const WORDS = new Set(['description', 'markdownDescription']);

// a property can have the name `description` itself
const withoutWords = (value) => {
  if (Array.isArray(value)) return value.map(withoutWords);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(
    Object.entries(value)
      .filter(([key, held]) => !(WORDS.has(key) && typeof held === 'string') && !key.startsWith('x-kubernetes-'))
      .map(([key, held]) => [key, withoutWords(held)]),
  );
};

const kubernetes = readFileSync(
  from('kubernetes_validate/kubernetes-json-schema/v1.33.0-local-strict/_definitions.json'),
  'utf8',
).replaceAll('/api/_definitions.json#/$defs/', '#/$defs/');
write('kubernetes.json', {
  $schema: 'https://json-schema.org/draft/2020-12/schema',
  $defs: closure(withoutWords(JSON.parse(kubernetes).$defs), [
    'io.k8s.api.batch.v1.Job',
    'io.k8s.api.core.v1.PersistentVolumeClaim',
  ]),
});

/** A shape of an AWS service model as JSON Schema. */
function schemaOf(shape) {
  const { type, required, members, member, value, enum: names, min, max, pattern } = shape;
  const reference = ({ shape }) => ({ $ref: `#/$defs/${shape}` });
  if (type === 'structure') {
    const properties = Object.fromEntries(Object.entries(members).map(([name, held]) => [name, reference(held)]));
    return { type: 'object', properties, required: required ?? [], additionalProperties: false };
  }
  if (type === 'list') return { type: 'array', items: reference(member), minItems: min, maxItems: max };
  if (type === 'map') return { type: 'object', additionalProperties: reference(value) };
  if (type === 'string') return { type, enum: names, minLength: min, maxLength: max, pattern };
  if (type === 'boolean') return { type };
  if (type === 'integer' || type === 'long') return { type: 'integer', minimum: min, maximum: max };
  if (type === 'float' || type === 'double') return { type: 'number', minimum: min, maximum: max };
  throw new Error(`a shape of the unknown type ${type}`);
}

const { shapes } = JSON.parse(gunzipSync(readFileSync(from('botocore/data/batch/2016-08-10/service-2.json.gz'))));
const { $defs } = JSON.parse(
  JSON.stringify({
    $defs: Object.fromEntries(
      Object.entries(shapes)
        .filter(([, { type }]) => type !== 'timestamp' && type !== 'blob')
        .map(([name, shape]) => [name, schemaOf(shape)]),
    ),
  }),
);
write('aws-batch.json', {
  $schema: 'https://json-schema.org/draft/2020-12/schema',
  $defs: closure($defs, ['RegisterJobDefinitionRequest', 'SubmitJobRequest']),
});

write(
  'gitlab-ci.json',
  withoutWords(JSON.parse(readFileSync(from('check_jsonschema/builtin_schemas/vendor/gitlab-ci.json'), 'utf8'))),
);
