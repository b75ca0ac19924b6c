import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { parse, stringify } from 'yaml';
import { ofPackage } from '../ready-made/project.ts';
import { mistakesIn, type Path } from './mistakes.ts';
import { awsJob, awsJobDefinition, type Check, github, gitlab, kubernetesClaim, kubernetesJob } from './schemas.ts';

const text = (name: string): string => ofPackage(`templates/fleet/${name}`);
const yaml = (name: string) => parse(text(name));
const json = (name: string) => JSON.parse(text(name));

const manifest = JSON.parse(ofPackage('package.json'));

const volume = yaml('kubernetes/volume.yaml');
const pods = { plan: yaml('kubernetes/plan.yaml'), check: yaml('kubernetes/check.yaml'), merge: yaml('kubernetes/merge.yaml') };
const definition = json('aws-batch/job-definition.json');
const batch = { plan: json('aws-batch/plan.json'), check: json('aws-batch/check.json'), merge: json('aws-batch/merge.json') };
const onGitHub = yaml('github-workflow.yml');
const onGitLab = yaml('gitlab-ci.yml');

/** What follows an option in the arguments of a command. */
const argumentOf = (option: string, args: readonly string[]): string => args[args.indexOf(option) + 1];

const argsOf = ({ spec }: (typeof pods)['plan']): string[] => spec.template.spec.containers[0].args;

describe('the published schemas', () => {
  const isNamed =
    (...paths: readonly string[]) =>
    (path: Path) =>
      paths.includes(path.join('/'));

  interface Ready {
    readonly name: string;
    readonly content: unknown;
    readonly check: Check;
    /** Whether a person chooses the keys in this place. */
    readonly isFree: (path: Path) => boolean;
    /** Whether the schema allows everything in this place; there are tests for it below. */
    readonly isUnknown?: (path: Path) => boolean;
  }

  const files: readonly Ready[] = [
    {
      name: 'kubernetes/volume.yaml',
      content: volume,
      check: kubernetesClaim,
      isFree: isNamed('spec/resources/requests'),
    },
    ...Object.entries(pods).map(([name, content]) => ({
      name: `kubernetes/${name}.yaml`,
      content,
      check: kubernetesJob,
      isFree: isNamed('spec/template/spec/containers/0/resources/requests', 'spec/template/spec/containers/0/resources/limits'),
    })),
    { name: 'aws-batch/job-definition.json', content: definition, check: awsJobDefinition, isFree: () => false },
    ...Object.entries(batch).map(([name, content]) => ({
      name: `aws-batch/${name}.json`,
      content,
      check: awsJob,
      isFree: () => false,
    })),
    {
      name: 'gitlab-ci.yml',
      content: onGitLab,
      check: gitlab,
      isFree: isNamed('', '.gq/variables'),
      isUnknown: (path) => path.join('/').startsWith('.gq/cache'),
    },
    {
      name: 'github-workflow.yml',
      content: onGitHub,
      check: (content) => github(stringify(content)),
      isFree: (path) => isNamed('env', 'jobs', 'jobs/plan/outputs', 'jobs/check/strategy/matrix')(path) || path.at(-1) === 'env',
      isUnknown: (path) => path.includes('with'),
    },
  ];

  it('know every file of the folder', () => {
    const all = readdirSync(join(import.meta.dirname, '../../templates/fleet'), { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile() && /\.(ya?ml|json)$/.test(entry.name))
      .map(({ name }) => name);
    expect(files.map(({ name }) => name.split('/').at(-1)).sort()).toEqual(all.sort());
  });

  it.each(files)('have nothing against $name', ({ content, check }) => {
    expect(check(content)).toEqual([]);
  });

  it.each(files)('find a mistake anywhere in $name', ({ content, check, isFree, isUnknown = () => false }) => {
    const mistakes = mistakesIn(content, isFree).filter(({ path }) => !isUnknown(path));
    expect(mistakes.length).toBeGreaterThan(7);
    expect(mistakes.filter(({ content }) => check(content).length === 0).map(({ what }) => what)).toEqual([]);
  });
});

describe('what the schemas do not know', () => {
  it('the cache on GitLab is that of the job that checks without shards', () => {
    expect(onGitLab['.gq'].cache).toEqual(parse(ofPackage('templates/gitlab-ci.yml')).levels.cache);
  });

  it('the actions on GitHub have these inputs, and are the versions that the other workflow has', () => {
    const inputs: Record<string, readonly string[]> = {
      'actions/checkout@v4': [],
      'actions/setup-node@v4': ['node-version', 'cache'],
      'actions/upload-artifact@v4': ['name', 'path', 'if-no-files-found', 'overwrite'],
      'actions/download-artifact@v4': ['name', 'path', 'pattern', 'merge-multiple'],
    };
    type Steps = readonly { readonly uses?: string; readonly with?: object }[];
    const used = Object.values<{ steps: Steps }>(onGitHub.jobs).flatMap(({ steps }) => steps.filter(({ uses }) => uses));
    expect(new Set(used.map(({ uses }) => uses))).toEqual(new Set(Object.keys(inputs)));
    for (const { uses = '', with: given = {} } of used) {
      expect(inputs[uses], uses).toEqual(expect.arrayContaining(Object.keys(given)));
    }
    const other = ofPackage('templates/github-workflow.yml');
    for (const uses of ['actions/checkout@v4', 'actions/setup-node@v4']) expect(other).toContain(`uses: ${uses}\n`);
  });
});

describe('the number of shards', () => {
  it('of Kubernetes is the same in plan and shards', () => {
    const { completions, parallelism, maxFailedIndexes, completionMode } = pods.check.spec;
    expect(argumentOf('--shards', argsOf(pods.plan))).toBe(String(completions));
    expect(completionMode).toBe('Indexed');
    expect(parallelism).toBeLessThanOrEqual(completions);
    expect(maxFailedIndexes).toBeLessThanOrEqual(completions);
  });

  it('of AWS Batch is the same in plan and array, and one that an array can have', () => {
    const { size } = batch.check.arrayProperties;
    expect(argumentOf('--shards', batch.plan.containerOverrides.command)).toBe(String(size));
    expect(size).toBeGreaterThanOrEqual(2);
    expect(size).toBeLessThanOrEqual(10_000);
  });

  it('of GitHub is in one place only, and one that a matrix can have', () => {
    const { SHARDS } = onGitHub.env;
    expect(SHARDS).toBeLessThanOrEqual(256);
    expect(text('github-workflow.yml')).not.toMatch(/strategy\.job-total\s*\}\}/);
    const steps = onGitHub.jobs.check.steps as { readonly run?: string; readonly env?: Record<string, string> }[];
    expect(steps.flatMap(({ env }) => Object.entries(env ?? {}))).toEqual([
      // biome-ignore lint/suspicious/noTemplateCurlyInString: an expression of GitHub
      ['GQ_SHARD', '${{ matrix.shard }}/${{ env.SHARDS }}'],
    ]);
    expect(JSON.stringify(onGitHub.jobs)).not.toMatch(new RegExp(`\\b${SHARDS}\\b`));
  });

  it('of GitLab is the same in plan and shards, and one that GitLab allows', () => {
    const [plan] = onGitLab['gq-plan'].script as string[];
    const { parallel } = onGitLab['gq-check'];
    expect(argumentOf('--shards', plan.split(' '))).toBe(String(parallel));
    expect(parallel).toBeLessThanOrEqual(200);
  });
});

it('the version is that of the package, everywhere', () => {
  const all = [text('Dockerfile'), ...Object.values(pods).map((job) => JSON.stringify(job)), JSON.stringify(definition)];
  for (const file of all) {
    const versions = [...file.matchAll(/(?:gq:|gravity-quest-toolkit@)([\w.-]+)/g)].map(([, version]) => version);
    expect(versions.length).toBeGreaterThan(0);
    expect(new Set(versions)).toEqual(new Set([manifest.version]));
  }
});

/** How a container ended: 137 is the end by SIGKILL, 143 by SIGTERM. */
interface End {
  readonly code: number;
  /** Its host was drained, taken back or lost. */
  readonly lostHost?: boolean;
  readonly outOfMemory?: boolean;
}

describe('on Kubernetes', () => {
  type Rule = {
    readonly action: 'Ignore' | 'FailIndex' | 'FailJob' | 'Count';
    readonly onExitCodes?: { readonly containerName: string; readonly operator: 'In' | 'NotIn'; readonly values: number[] };
    readonly onPodConditions?: readonly { readonly type: string; readonly status: string }[];
  };

  /** What the first rule that fits says, as Kubernetes decides. */
  function becomes(job: (typeof pods)['plan'], { code, lostHost = false }: End): Rule['action'] {
    const rules: readonly Rule[] = job.spec.podFailurePolicy.rules;
    const fits = ({ onExitCodes, onPodConditions }: Rule) =>
      onExitCodes === undefined
        ? lostHost && onPodConditions?.some(({ type, status }) => type === 'DisruptionTarget' && status === 'True')
        : onExitCodes.values.includes(code) === (onExitCodes.operator === 'In');
    return rules.find(fits)?.action ?? 'Count';
  }

  it('a shard that lost its node is started again, one that was killed is counted, and exit code 2 is final', () => {
    expect(becomes(pods.check, { code: 143, lostHost: true })).toBe('Ignore');
    expect(becomes(pods.check, { code: 137, lostHost: true })).toBe('Ignore');
    expect(becomes(pods.check, { code: 137 })).toBe('Count');
    expect(becomes(pods.check, { code: 2 })).toBe('FailIndex');
    expect(pods.check.spec.backoffLimitPerIndex).toBeGreaterThan(0);
  });

  it('plan and merge are tried again only when they were killed', () => {
    expect([becomes(pods.plan, { code: 2 }), becomes(pods.plan, { code: 137 })]).toEqual(['FailJob', 'Count']);
    expect([1, 2, 3].map((code) => becomes(pods.merge, { code }))).toEqual(['FailJob', 'FailJob', 'FailJob']);
    expect(becomes(pods.merge, { code: 137 })).toBe('Count');
    expect(becomes(pods.merge, { code: 1, lostHost: true })).toBe('Ignore');
  });

  it.each(Object.entries(pods))('the Job %s has what the server demands', (_, job) => {
    const { template, podFailurePolicy, completionMode } = job.spec;
    const [container, ...others] = template.spec.containers;
    expect(others).toEqual([]);
    expect(template.spec.restartPolicy).toBe('Never');
    for (const { action, onExitCodes, onPodConditions } of podFailurePolicy.rules as Rule[]) {
      expect(action === 'FailIndex' ? ['Indexed'] : ['Indexed', undefined]).toContain(completionMode);
      expect([onExitCodes, onPodConditions].filter((rule) => rule !== undefined)).toHaveLength(1);
      if (onExitCodes === undefined) continue;
      expect(onExitCodes.containerName).toBe(container.name);
      expect(onExitCodes.values).toEqual([...new Set(onExitCodes.values)].sort((a, b) => a - b));
      expect(onExitCodes.values).not.toContain(0);
    }
    const volumes = template.spec.volumes as { readonly name: string; readonly persistentVolumeClaim?: { claimName: string } }[];
    expect(volumes.map(({ name }) => name).sort()).toEqual(
      container.volumeMounts.map(({ name }: { name: string }) => name).sort(),
    );
    expect(volumes.flatMap(({ persistentVolumeClaim: claim }) => claim?.claimName ?? [])).toEqual([volume.metadata.name]);
    expect(container.workingDir).toBe(container.volumeMounts[0].mountPath);
    expect(template.spec.activeDeadlineSeconds).toBeGreaterThan(0);
    expect(volume.spec.accessModes).toEqual(['ReadWriteMany']);
  });

  it('the pods of all Jobs are the same but for their arguments', () => {
    const withoutArgs = (job: (typeof pods)['plan']) => {
      const { template } = structuredClone(job.spec);
      delete template.spec.containers[0].args;
      return template;
    };
    expect(withoutArgs(pods.plan)).toEqual(withoutArgs(pods.check));
    expect(withoutArgs(pods.merge)).toEqual(withoutArgs(pods.check));
  });
});

describe('on AWS Batch', () => {
  type Condition = {
    readonly action: 'RETRY' | 'EXIT';
    readonly onStatusReason?: string;
    readonly onReason?: string;
    readonly onExitCode?: string;
  };
  type Strategy = { readonly attempts: number; readonly evaluateOnExit: readonly Condition[] };

  const fits = (pattern: string | undefined, value: string): boolean =>
    pattern === undefined || (pattern.endsWith('*') ? value.startsWith(pattern.slice(0, -1)) : value === pattern);

  /** What the first condition that fits says; without one a job is tried again. */
  function becomes({ evaluateOnExit }: Strategy, { code, lostHost = false, outOfMemory = false }: End): Condition['action'] {
    const found = evaluateOnExit.find(
      ({ onStatusReason, onReason, onExitCode }) =>
        fits(onStatusReason, lostHost ? 'Host EC2 (instance i-0a1b2c3d) terminated.' : 'Essential container in task exited') &&
        fits(onReason, outOfMemory ? 'OutOfMemoryError: Container killed due to memory usage' : '') &&
        fits(onExitCode, String(code)),
    );
    return found?.action ?? 'RETRY';
  }

  const merge: Strategy = batch.merge.retryStrategy;
  const shard: Strategy = definition.retryStrategy;

  it('a shard that lost its host or was killed is tried again, and exit code 2 is final', () => {
    expect(becomes(shard, { code: 137, lostHost: true })).toBe('RETRY');
    expect(becomes(shard, { code: 137 })).toBe('RETRY');
    expect(becomes(shard, { code: 2 })).toBe('EXIT');
    expect(becomes(shard, { code: 137, outOfMemory: true })).toBe('EXIT');
  });

  it('merge is tried again only when it lost its host', () => {
    expect([1, 2, 3].map((code) => becomes(merge, { code }))).toEqual(['EXIT', 'EXIT', 'EXIT']);
    expect(becomes(merge, { code: 137, lostHost: true })).toBe('RETRY');
  });

  it.each([shard, merge])('conditions are written as the service demands: %j', ({ attempts, evaluateOnExit }) => {
    expect(attempts).toBeGreaterThan(1);
    expect(attempts).toBeLessThanOrEqual(10);
    expect(evaluateOnExit.length).toBeLessThanOrEqual(5);
    for (const { onStatusReason = 'a', onReason = 'a', onExitCode = '1' } of evaluateOnExit) {
      for (const pattern of [onStatusReason, onReason]) expect(pattern).toMatch(/^[\w.:\s]*\*?$/);
      expect(onExitCode).toMatch(/^\d*\*?$/);
    }
  });

  it('jobs are of the definition, whose volume is where the image works', () => {
    for (const { jobDefinition } of Object.values(batch)) expect(jobDefinition).toBe(definition.jobDefinitionName);
    const { volumes, mountPoints } = definition.containerProperties;
    expect(mountPoints.map(({ sourceVolume }: { sourceVolume: string }) => sourceVolume)).toEqual(
      volumes.map(({ name }: { name: string }) => name),
    );
    expect(text('Dockerfile')).toContain(`\nWORKDIR ${mountPoints[0].containerPath}\n`);
    // the least that the service takes
    expect(definition.timeout.attemptDurationSeconds).toBeGreaterThanOrEqual(60);
  });
});

describe('on GitLab', () => {
  it('a job is tried again when the runner failed, never when gq did, and merge runs in any case', () => {
    const { retry } = onGitLab['.gq'];
    expect(retry.max).toBe(2);
    for (const reason of ['always', 'script_failure', 'unknown_failure']) expect(retry.when).not.toContain(reason);
    expect(onGitLab['gq-merge'].when).toBe('always');
    expect(onGitLab['gq-merge'].needs).toEqual(['gq-plan', 'gq-check']);
  });
});
