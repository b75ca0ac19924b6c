import { createHash } from 'node:crypto';
import * as z from 'zod';
import { ENGINE_ID } from '../../game/index.ts';
import { strictJson } from '../../schema/json/index.ts';
import { codeFingerprint } from '../cache/index.ts';
import { readRegularFile } from '../io/index.ts';
import { Failure, namedPath, readVersion, systemReason } from '../terminal/index.ts';
import { JOBS } from './job.ts';

export const PLAN_VERSION = 1;

/** Shards of a plan at most. */
export const MOST_SHARDS = 10_000;

/** Bytes of a plan at most. */
const LARGEST = 64 * 1024 * 1024;

const count = z.int().min(0);
const hex = (digits: number) => z.string().regex(new RegExp(`^[0-9a-f]{${digits}}$`));

const planSchema = z.strictObject({
  /** Says what the file is. */
  gq: z.literal('plan'),
  version: z.literal(PLAN_VERSION),
  toolkit: z.string(),
  engine: z.string(),
  /** The fingerprint of the code that decides. */
  code: hex(64),
  job: z.enum(JOBS),
  /** What the set consists of, as the working directory sees it. */
  paths: z.array(z.string()).min(1),
  /** What is left out of directories. */
  ignore: z.strictObject({ file: z.string().nullable(), directory: z.string(), patterns: z.array(z.string()) }),
  /** What the job does with each level; known to the job. */
  settings: z.record(z.string(), z.unknown()),
  /** What the report depends on besides the results; known to the job. */
  report: z.record(z.string(), z.unknown()),
  levels: count.min(1),
  /** The number of levels in a block, and the hashes of the blocks. */
  block: count.min(1),
  blocks: z.array(hex(32)),
  /** Of each shard, how many levels it has, the hash over them, and the levels that the rule would give to another. */
  shards: z
    .array(z.strictObject({ levels: count, hash: hex(64), assigned: z.array(hex(12)).optional() }))
    .min(1)
    .max(MOST_SHARDS),
  /** The hash of all this. */
  seal: hex(64),
});

/** How a set is split, and what must be equal everywhere. */
export type Plan = z.infer<typeof planSchema>;

/** What says which code has decided. */
export interface Code {
  readonly toolkit: string;
  readonly engine: string;
  readonly code: string;
}

/** The code that runs. */
export const ownCode = (): Code => ({ toolkit: readVersion(), engine: ENGINE_ID, code: codeFingerprint() });

const sealOf = ({ seal: _, ...rest }: Plan): string => createHash('sha256').update(JSON.stringify(rest)).digest('hex');

/** Completes a plan. */
export function sealed(plan: Omit<Plan, 'seal'>): Plan {
  // the keys in the order in which a reader gets them
  const ordered = planSchema.parse({ ...plan, seal: '0'.repeat(64) });
  return { ...ordered, seal: sealOf(ordered) };
}

/** The text of a plan. */
export const planText = (plan: Plan): string => `${JSON.stringify(plan, null, 1)}\n`;

/**
 * Reads a plan.
 * @throws Failure if it can't be read, is no plan, has been changed, or is of another version of the toolkit
 */
export function readPlan(path: string, code: Code = ownCode()): Plan {
  const refuse = (why: string): Failure => new Failure(`${namedPath(path)}: ${why}`);
  let text: string;
  try {
    const bytes = readRegularFile(path, LARGEST);
    if (bytes.length > LARGEST) throw refuse(`it is larger than any plan: expected at most ${LARGEST} bytes`);
    text = Buffer.from(bytes).toString();
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw refuse(`the plan can't be read: ${systemReason(error)}`);
  }
  const json = strictJson(text);
  if (!json.ok)
    throw refuse(
      `line ${json.line}, column ${json.column}: expected a plan, found no JSON of one: ${json.message}; gq plan makes one`,
    );
  const { value } = json;
  const { gq, version } = (value ?? {}) as { readonly gq?: unknown; readonly version?: unknown };
  if (gq !== 'plan') throw refuse('expected a plan; gq plan makes one');
  if (version !== PLAN_VERSION) {
    throw refuse(
      `expected a plan of version ${PLAN_VERSION}, found version ${JSON.stringify(version)}: make it with this gq, ${code.toolkit}`,
    );
  }
  const parsed = planSchema.safeParse(value);
  if (!parsed.success) {
    const [{ path: at, message }] = parsed.error.issues;
    throw refuse(`it is not a valid plan: ${at.join('.')}: ${message}; make it anew with gq plan`);
  }
  const plan = parsed.data;
  if (plan.seal !== sealOf(plan))
    throw refuse('it has been changed since gq plan wrote it, or is damaged; make it anew with gq plan');
  expectSameCode(path, plan, code);
  return plan;
}

function expectSameCode(path: string, plan: Plan, own: Code): void {
  const advice = 'use the same version of gravity-quest-toolkit everywhere, or make the plan anew';
  if (plan.engine !== own.engine) {
    throw new Failure(
      `${namedPath(path)}: the plan is for engine ${plan.engine} (gq ${plan.toolkit}), found engine ${own.engine} (gq ${own.toolkit}): ${advice}`,
    );
  }
  if (plan.code === own.code) return;
  throw new Failure(
    `${namedPath(path)}: the plan was made by gq ${plan.toolkit} with code ${plan.code.slice(0, 12)}, this is gq ${own.toolkit} with code ${own.code.slice(0, 12)}: ${advice}`,
  );
}
