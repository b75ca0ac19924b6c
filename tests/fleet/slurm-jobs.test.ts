import { execFileSync } from 'node:child_process';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { arrayJob, mergeJob, type SlurmOrder, submission } from '../../cli/fleet/index.ts';

const ORDER: SlurmOrder = {
  directory: '/levels',
  program: ['/usr/bin/node', '/opt/gq/main.js'],
  command: 'check',
  plan: 'plan.json',
  out: 'out',
  shards: [0, 1, 2, 3, 6],
  name: 'gq',
  cpus: 2,
  atOnce: null,
  partition: null,
  time: null,
  memory: null,
};

// no line break within a path: a heredoc ends at a line
const letters = fc.constantFrom(...'ab /\\\'"$`!*?()&;|<>#~=%{}[]^\t-:é@');
const text = fc.string({ unit: letters, minLength: 1, maxLength: 12 });
const order: fc.Arbitrary<SlurmOrder> = fc.record({
  directory: fc.constant('/'),
  // stands for gq: prints its arguments, each on a line
  program: fc.tuple(fc.constant('/usr/bin/printf'), fc.constant('%s\\n')),
  command: fc.constantFrom('check', 'solve', 'difficulty', 'verify'),
  plan: text,
  out: text,
  shards: fc.uniqueArray(fc.nat({ max: 99 }), { minLength: 1 }),
  name: text,
  cpus: fc.integer({ min: 1, max: 256 }),
  atOnce: fc.option(fc.integer({ min: 1, max: 99 })),
  partition: fc.option(text),
  time: fc.option(text),
  memory: fc.option(text),
});

const run = (script: string, env: Record<string, string> = {}): string[] =>
  execFileSync('sh', { input: script, encoding: 'utf8', env }).split('\n').slice(0, -1);

const asPath = (path: string): string => (path.startsWith('-') ? `./${path}` : path);

describe('the array job', () => {
  it('does each shard with a task of its own', () => {
    expect(arrayJob(ORDER).args).toContain('--array=0-3,6');
    expect(arrayJob({ ...ORDER, atOnce: 4 }).args).toContain('--array=0-3,6%4');
    expect(run(arrayJob({ ...ORDER, program: ['echo', 'main.js'] }).script, { SLURM_ARRAY_TASK_ID: '6' })).toEqual([
      'main.js check --plan plan.json --shard 6 --out out --jobs 2',
    ]);
  });

  it('gives Slurm only what was asked for', () => {
    expect(arrayJob(ORDER).args.filter((arg) => /^--(partition|time|mem)\b/.test(arg))).toEqual([]);
    const asked = arrayJob({ ...ORDER, partition: 'short', time: '1:00:00', memory: '2G' });
    expect(asked.args).toEqual(expect.arrayContaining(['--partition=short', '--time=1:00:00', '--mem=2G', '--cpus-per-task=2']));
  });

  // Slurm replaces %a in the names of logs
  it('has logs in the directory of results, whatever its name', () => {
    const logs = (out: string) => arrayJob({ ...ORDER, out }).args.filter((arg) => arg.startsWith('--output'));
    expect(logs('out')).toEqual(['--output=out/logs/shard-%a.log']);
    expect(logs('/a b//')).toEqual(['--output=/a b/logs/shard-%a.log']);
    expect(logs('/')).toEqual(['--output=/logs/shard-%a.log']);
    expect(logs('100%a')).toEqual(['--output=100%%a/logs/shard-%a.log']);
  });
});

describe('the merge job', () => {
  it('comes after the tasks, also after those that failed, and writes the report', () => {
    const { args, script } = mergeJob({ ...ORDER, program: ['echo', 'main.js'] }, '17');
    expect(args).toContain('--dependency=afterany:17');
    expect(run(script)).toEqual(['main.js merge out --plan plan.json --format json -o out/report.json']);
  });
});

describe('the words of both jobs', () => {
  it('are those of the order, whatever characters they have', () => {
    fc.assert(
      fc.property(order, (asked) => {
        const { command, plan, out, cpus } = asked;
        expect(run(arrayJob(asked).script, { SLURM_ARRAY_TASK_ID: '7' })).toEqual([
          ...[command, '--plan', asPath(plan), '--shard', '7', '--out', asPath(out), '--jobs', `${cpus}`],
        ]);
        const merge = run(mergeJob(asked, '17').script);
        expect(merge.slice(0, 4)).toEqual(['merge', asPath(out), '--plan', asPath(plan)]);
      }),
      { numRuns: 30 },
    );
  });
});

describe('a submission as a script', () => {
  // stands for sbatch: shows its arguments and its input, and answers with a number as a federation of clusters does
  const sbatch = `sbatch() { printf '%s\\n' "$@" >&3; cat >&3; echo '17;north'; }\nmkdir() { :; }\n`;

  it('gives sbatch the same arguments and scripts', () => {
    fc.assert(
      fc.property(order, (asked) => {
        const script = `exec 3>&1 >/dev/null\n${sbatch}${submission(asked)}`;
        const [array, merge] = [arrayJob(asked), mergeJob(asked, '17')];
        const expected = [...array.args, array.script, ...merge.args, merge.script].map((line) => line.replace(/\n$/, ''));
        expect(run(script).join('\n')).toBe(expected.join('\n'));
      }),
      { numRuns: 30 },
    );
  });

  it('ends where sbatch refuses', () => {
    const refusing = 'sbatch() { echo refused >&2; return 1; }\nmkdir() { :; }\n';
    const script = `${refusing}${submission({ ...ORDER, directory: '/' })}\necho went on`;
    expect(() => execFileSync('sh', { input: script, stdio: 'pipe' })).toThrow(/refused/);
  });
});
