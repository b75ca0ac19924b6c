import { spawnSync } from 'node:child_process';
import { chmodSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import process from 'node:process';
import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { submission } from '../../cli/fleet/index.ts';
import { gq, MAIN, makeFiles } from '../cli/gq.ts';
import { planOf } from './plan.ts';

// What Slurm makes of the jobs is tested with Slurm, in slurm.deep.test.ts. Here stands a script for it.

let work: ReturnType<typeof makeFiles>;
let bin: string;

beforeEach(async () => {
  work = makeFiles({ 'bin/none': '' });
  bin = join(work.directory, 'bin');
  await planOf(work.directory, 8);
});
afterEach(() => work.remove());

/** A command that stands in PATH before all others. */
function stub(name: string, script: string): void {
  writeFileSync(join(bin, name), `#!/bin/sh\n${script}\n`);
  chmodSync(join(bin, name), 0o755);
}

/** sbatch that keeps the arguments and the input of each call and counts jobs from 41. */
const KEEPING = 'n=$(ls "$KEPT" | wc -l); printf "%s\\n" "$@" > "$KEPT/$n"; cat >> "$KEPT/$n"; echo $((n + 41))';

function stubCluster(size: number | null, sbatch: string): void {
  stub('scontrol', size === null ? 'echo "no cluster" >&2; exit 1' : `echo "MaxArraySize            = ${size}"`);
  stub('sbatch', sbatch);
}

const submit = (...args: string[]) =>
  gq(['submit', 'slurm', '--plan', 'plan.json', '--out', 'out', ...args], {
    cwd: work.directory,
    env: { PATH: `${bin}${delimiter}${process.env.PATH}`, KEPT: kept() },
  });

const kept = (): string => {
  mkdirSync(join(work.directory, 'kept'), { recursive: true });
  return join(work.directory, 'kept');
};
const job = (n: number): string => readFileSync(join(kept(), `${n}`), 'utf8');

describe('gq submit slurm', () => {
  it('submits the shards and a merge after them, with the gq that runs', async () => {
    stubCluster(1001, KEEPING);
    const { code, stdout, stderr } = await submit('--name', 'night', '--max-running', '3');
    expect({ code, stderr }).toEqual({ code: 0, stderr: '' });
    expect(stdout).toMatch(/^job 41: all 8 shards\njob 42: the merge after them, which writes out\/report\.json\n/);
    expect(job(0)).toMatch(/^--array=0-7%3$/m);
    expect(job(0)).toContain(`--chdir=${work.directory}\n`);
    expect(job(0)).toContain(`exec ${process.execPath} ${MAIN} check --plan plan.json --shard "$SLURM_ARRAY_TASK_ID"`);
    expect(job(1)).toMatch(/^--dependency=afterany:41$/m);
    // Slurm drops what a task prints if the directory is not there
    expect(existsSync(join(work.directory, 'out', 'logs'))).toBe(true);
  });

  it('submits chosen shards', async () => {
    stubCluster(1001, KEEPING);
    expect((await submit('--only', '6,2-4')).stdout).toMatch(/^job 41: 4 of 8 shards: 2-4,6$/m);
    expect(job(0)).toMatch(/^--array=2-4,6$/m);
  });

  it('prints the jobs with --dry-run, and makes nothing', async () => {
    stubCluster(1001, KEEPING);
    const { code, stdout, stderr } = await submit('--dry-run');
    expect({ code, stderr }).toEqual({ code: 0, stderr: '' });
    expect(stdout.match(/^sbatch .*/gm)).toHaveLength(2);
    expect(existsSync(join(work.directory, 'out'))).toBe(false);
    expect(existsSync(join(kept(), '0'))).toBe(false);
  });

  it('needs no cluster for --dry-run, but doubts more shards than most clusters allow', async () => {
    stubCluster(null, 'exit 1');
    expect(await submit('--dry-run')).toMatchObject({ code: 0, stderr: '' });
    await planOf(work.directory, 1002);
    expect((await submit('--dry-run')).stderr).toMatch(/1002 shards.*MaxArraySize.*above 1000/);
    expect((await submit('--dry-run', '--only', '0-1000')).stderr).toBe('');
  });

  it('refuses more shards than the cluster allows', async () => {
    stubCluster(8, KEEPING);
    expect(await submit()).toMatchObject({ code: 0 });
    await planOf(work.directory, 9);
    const { code, stderr } = await submit();
    expect(code).toBe(2);
    expect(stderr).toMatch(/9 shards.*tasks 0 to 7.*MaxArraySize=8.*--shards 8 or fewer/);
    expect(await submit('--only', '0-7')).toMatchObject({ code: 0 });
  });

  it('says what sbatch says when it refuses', async () => {
    stubCluster(1001, 'echo "sbatch: error: invalid partition specified: x" >&2; exit 1');
    const { code, stdout, stderr } = await submit();
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toMatch(/^error: sbatch refused the array job: sbatch: error: invalid partition specified: x$/m);
  });

  it.each([
    ['says nothing', 'exit 3', /it said nothing and ended with exit code 3/],
    ['gives no number', 'cat > /dev/null; echo soon', /refused the array job: soon/],
    ['is killed', 'kill -9 $$', /SIGKILL/],
  ])('fails if sbatch %s', async (_, script, message) => {
    stubCluster(1001, script);
    const { code, stderr } = await submit();
    expect(code).toBe(2);
    expect(stderr).toMatch(message);
  });

  it('names the job of the shards if that of the merge is refused', async () => {
    stubCluster(1001, `case "$*" in *dependency*) echo no >&2; exit 1;; esac; ${KEEPING}`);
    const { code, stderr } = await submit();
    expect(code).toBe(2);
    expect(stderr).toMatch(/refused the merge job: no\n.*job 41 .*gq merge out --plan plan\.json.*scancel 41/);
  });

  it('says where to run it if there is no sbatch', async () => {
    stub('scontrol', 'exit 1');
    const { code, stderr } = await gq(['submit', 'slurm', '--plan', 'plan.json', '--out', 'out'], {
      cwd: work.directory,
      env: { PATH: bin },
    });
    expect(code).toBe(2);
    expect(stderr).toMatch(/needs the command sbatch.*--dry-run/);
  });

  it('refuses an output directory that cannot be', async () => {
    stubCluster(1001, KEEPING);
    writeFileSync(join(work.directory, 'out'), 'a file');
    const { code, stderr } = await submit();
    expect(code).toBe(2);
    expect(stderr).toMatch(/^error: --out out: .*expected a directory/);
    expect(existsSync(join(kept(), '0'))).toBe(false);
  });

  it.each([
    [['--only', '8'], /--only 8: found no shard 8: the plan has 8/],
    [['--only', 'x'], /--only "x": expected shards, as in 2,5-7/],
    [['--only', '1', '--missing'], /expected one of them/],
    [['--cpus', '0'], /from 1 to 256/],
    [['--max-running', '0'], /from 1 to/],
    [['--name', ''], /--name ""/],
    [['--partition', ''], /--partition ""/],
  ])('refuses %j', async (args, message) => {
    stubCluster(1001, KEEPING);
    const { code, stderr } = await submit(...args);
    expect(code).toBe(2);
    expect(stderr).toMatch(message);
    expect(existsSync(join(kept(), '0'))).toBe(false);
  });

  it.each([
    ['a line that ends the script', '--name', 'a\nARRAY_JOB\ntouch pwned\n'],
    ['a setting of Slurm', '--out', 'out\n#SBATCH --uid=0'],
    ['a carriage return', '--partition', 'short\r'],
    ['an escape', '--mem', '1G\u001b[2K'],
    ['a tab', '--time', '1\t'],
    ['another direction of writing', '--name', 'a\u202eb'],
  ])('refuses a name with %s', async (_, option, value) => {
    stubCluster(1001, KEEPING);
    for (const dryRun of [['--dry-run'], []]) {
      const { code, stdout, stderr } = await submit(option, value, ...dryRun);
      expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
      expect(stderr).toMatch(/^error: --\w+ "[ -~]*\\u[0-9a-f]{4}[ -~]*": expected a name without line breaks .* rename it\n$/);
    }
    expect(existsSync(join(kept(), '0'))).toBe(false);
  });

  it('refuses a plan and a directory with a line break in their names', async () => {
    const plan = join(work.directory, 'a\nb.json');
    writeFileSync(plan, readFileSync(join(work.directory, 'plan.json')));
    expect((await submit('--plan', 'a\nb.json', '--dry-run')).stderr).toContain('error: --plan "a\\u000ab.json": expected');
    const cwd = join(work.directory, 'c\nd');
    mkdirSync(cwd);
    const { code, stderr } = await gq(['submit', 'slurm', '--plan', '../plan.json', '--out', 'out', '--dry-run'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toContain('error: the current directory "');
  });
});

describe('the script of --dry-run', () => {
  const PIECES = [
    ...['$(touch pwned)', '`touch pwned`', ';touch pwned;', '|touch pwned', '&touch pwned&', '>pwned', '$HOME', "'", '"'],
    ...['\\', ' ', '*', '~', '#', '!', '%a', '%%', '=', '-', '--', '(', ')', '{a,b}', '<<EOF', 'ARRAY_JOB', 'MERGE_JOB'],
    ...['@array@', '$&', "$'", '#SBATCH', 'a', 'ü', '\u{1f680}', ':', ',', '[', ']', '?', '^', '+', '@', '.'],
  ];
  const hostile = fc.array(fc.constantFrom(...PIECES), { minLength: 1, maxLength: 6 }).map((parts) => parts.join(''));
  const fileName = hostile.filter((name) => !/^\.{1,2}$|^in$/.test(name));

  // keeps the arguments and runs the script as a task of the array would
  const SBATCH =
    'n=$(ls kept | wc -l); printf "%s\\0" "$@" > kept/$n.args; cat > kept/$n.sh; SLURM_ARRAY_TASK_ID=5 sh kept/$n.sh > kept/$n.run; echo 41';

  it('runs what it is for and nothing else, whatever the names', () => {
    stub('sbatch', SBATCH);
    fc.assert(
      fc.property(fc.tuple(fileName, fileName, hostile, fileName, hostile, fileName), (names) => {
        rmSync(join(work.directory, 'script'), { recursive: true, force: true });
        const [folder, program, name, plan, partition, out] = names;
        const directory = join(work.directory, 'script', 'in', folder);
        mkdirSync(join(directory, 'kept'), { recursive: true });
        const main = join(work.directory, 'script', program);
        writeFileSync(main, '#!/bin/sh\nprintf "%s\\0" "$0" "$@"\n');
        const order = { directory, program: ['/bin/sh', main], command: 'check', plan, out, shards: [0, 1], name } as const;
        const text = submission({ ...order, cpus: 2, atOnce: null, partition, time: null, memory: null });
        expect(spawnSync('bash', ['-n'], { input: text }).status).toBe(0);
        const env = { ...process.env, PATH: `${bin}${delimiter}${process.env.PATH}` };
        const { status, stderr } = spawnSync('sh', [], { input: text, env, encoding: 'utf8', cwd: work.directory });
        expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
        const words = (file: string) =>
          readFileSync(join(directory, 'kept', file), 'utf8')
            .split('\0')
            .slice(0, -1);
        const asPath = (path: string) => (path.startsWith('-') ? `./${path}` : path);
        expect(words('0.run')).toEqual([
          main,
          'check',
          '--plan',
          asPath(plan),
          '--shard',
          '5',
          '--out',
          asPath(out),
          '--jobs',
          '2',
        ]);
        expect(words('3.args')).toEqual(expect.arrayContaining([`--job-name=${name}-merge`, `--partition=${partition}`]));
        expect(words('3.args')).toContain('--dependency=afterany:41');
        expect(words('3.run').slice(0, 5)).toEqual([main, 'merge', asPath(out), '--plan', asPath(plan)]);
        expect(spawnSync('find', [work.directory, '-name', 'pwned'], { encoding: 'utf8' }).stdout).toBe('');
      }),
      { numRuns: 40 },
    );
  });
});
