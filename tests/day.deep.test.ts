import { appendFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, describe, expect, it } from 'vitest';
import { parse as parseYaml } from 'yaml';
import { readLevel } from '../schema/index.ts';
import { gqCovered, gq as gqIn, MAIN } from './cli/gq.ts';
import { PROJECT } from './docs/page.ts';
import { runIn } from './ready-made/project.ts';
import { gqEdit } from './server/command.ts';

// A day with git and CI, in one repository, with the built command and the git of the machine: the parts follow each other.

const FIRST = 'levels/01-first-pull.level.json';
const SWING = 'levels/02-first-swing.level.json';
const LOCK = 'gq.lock.json';

const root = mkdtempSync(join(tmpdir(), 'gq-day-'));
afterAll(() => rmSync(root, { recursive: true, force: true }));

const at = (name: string): string => join(root, name);
const read = (name: string): string => readFileSync(at(name), 'utf8');
const readJson = (name: string) => JSON.parse(read(name));
const linesOf = (name: string): string[] => read(name).split('\n');
const levelIn = (name: string) => {
  const reading = readLevel(readFileSync(at(name)));
  if (!reading.ok) throw new Error(`${name}: ${reading.problems[0].message}`);
  return reading.document.file;
};

/** Changes a file as a person does in an editor. */
function edit(name: string, from: string, to: string): void {
  const pieces = read(name).split(from);
  if (pieces.length !== 2) throw new Error(`${name}: expected ${from} once, found it ${pieces.length - 1} times`);
  writeFileSync(at(name), pieces.join(to));
}

const gq = (...args: string[]) => gqIn(args, { cwd: root });

/** Git without the settings of the user. Its messages and those of its drivers are one text, in which nobody parses a stream. */
function git(...args: string[]): { status: number | null; out: string; said: string } {
  const env = { GIT_CONFIG_GLOBAL: '/dev/null', GIT_CONFIG_SYSTEM: '/dev/null', GIT_EDITOR: 'true' };
  const { status, stdout, stderr } = runIn(root, 'git', args, env);
  return { status, out: stdout, said: stdout + stderr };
}

function gitDoes(...args: string[]): string {
  const { status, out, said } = git(...args);
  if (status !== 0) throw new Error(`git ${args.join(' ')} ended with ${status}: ${said}`);
  return out;
}

function commit(message: string): void {
  gitDoes('add', '-A');
  gitDoes('commit', '-qm', message);
}

/** What `gq check` says of every level. */
async function verdicts(...options: string[]) {
  const { code, stdout } = await gq('check', '--format', 'json', ...options);
  const levels: {
    file: string;
    verdict: string;
    problems: { code: string; message: string; line: number; severity: string }[];
  }[] = JSON.parse(stdout).levels;
  return { code, levels, problems: levels.flatMap(({ problems }) => problems) };
}

const GREEN = { code: 0, problems: [], levels: [{ verdict: 'completable' }, { verdict: 'completable' }] };

let failed: string | null = null;

/** A part of the day. Those after one that failed do not run: they would only hide the cause. */
function part(name: string, body: () => Promise<void>): void {
  it(name, async () => {
    if (failed !== null) throw new Error(`not run, since this part failed: ${failed}`);
    failed = name;
    await body();
    failed = null;
  });
}

interface Step {
  readonly uses?: string;
  readonly with?: Readonly<Record<string, string>>;
  readonly env?: Readonly<Record<string, string>>;
  readonly run?: string;
}

/** Runs the step of the workflow that `gq init` wrote as GitHub does. @param more inputs that a person adds */
function ci(more: Readonly<Record<string, string>> = {}) {
  const steps: Step[] = parseYaml(read('.github/workflows/levels.yml')).jobs.check.steps;
  const step = steps.find(({ uses }) => uses?.startsWith('./'));
  if (step?.uses === undefined) throw new Error('expected a step that uses the installed action');
  const action = parseYaml(read(join(step.uses, 'action.yml')));
  const given: Record<string, string> = { ...step.with, ...more };
  const unknown = Object.keys(given).filter((name) => !(name in action.inputs));
  if (unknown.length > 0) throw new Error(`the action has no input ${unknown}`);
  const script: Step = action.runs.steps[0];
  const inputs = Object.entries(script.env ?? {}).map(([name, value]) => [
    name,
    value.replace(/\$\{\{ inputs\.([\w-]+) \}\}/g, (_, input: string) => given[input] ?? action.inputs[input].default),
  ]);
  const [summary, output] = [at('.git/summary.md'), at('.git/output')];
  for (const file of [summary, output]) rmSync(file, { force: true });
  const { status, stdout, stderr } = runIn(root, 'bash', ['--noprofile', '--norc', '-eo', 'pipefail', '-c', script.run ?? ''], {
    CI: 'true',
    GITHUB_ACTIONS: 'true',
    GITHUB_WORKSPACE: root,
    GITHUB_STEP_SUMMARY: summary,
    GITHUB_OUTPUT: output,
    ...Object.fromEntries(inputs),
  });
  return { status, stdout, stderr, summary: readFileSync(summary, 'utf8'), output: readFileSync(output, 'utf8') };
}

/** Annotations as GitHub reads them. */
function annotationsIn(log: string): { severity: string; message: string; file?: string; title?: string; line?: string }[] {
  return [...log.matchAll(/^::(error|warning) ([^:]*)::(.*)$/gm)].map(([, severity, properties, message]) => ({
    severity,
    ...Object.fromEntries(properties.split(',').map((property) => property.split('='))),
    message: message.replaceAll('%0A', '\n'),
  }));
}

/** Where the run "solution" of the broken level begins: what its annotation points at. */
const lineOfSolution = (): number => linesOf(SWING).findIndex((line) => line.includes('"solution"'));

/** The tick of the collision, as the reports have it. */
let deadly = -1;

// npm links differently on Windows, and its runners have another bash
describe.runIf(process.platform !== 'win32')('a day with git and CI', () => {
  part('begins with gq init and gq git-setup in an empty repository', async () => {
    mkdirSync(at('node_modules/.bin'), { recursive: true });
    symlinkSync(PROJECT, at('node_modules/gravity-quest-toolkit'), 'dir');
    symlinkSync(MAIN, at('node_modules/.bin/gq'));
    gitDoes('init', '-qb', 'main');
    gitDoes('config', 'user.name', 'A Person');
    gitDoes('config', 'user.email', 'person@example.org');
    writeFileSync(at('.gitignore'), 'node_modules/\nreports/\n');
    expect(await gq('init', '--ci', 'github')).toMatchObject({ code: 0, stderr: '' });
    expect(await gq('git-setup')).toMatchObject({ code: 0, stderr: '' });
    expect(await verdicts()).toMatchObject(GREEN);
    const agreed = await gq('check', '--lock', LOCK, '--update-lock');
    expect(agreed).toMatchObject({ code: 0 });
    commit('the first levels');
    expect(await gq('git-setup', '--check')).toMatchObject({ code: 0 });
    expect(gitDoes('ls-files').trim().split('\n')).toEqual([
      '.gitattributes',
      '.github/workflows/levels.yml',
      '.gitignore',
      '.vscode/settings.json',
      'gq.config.json',
      LOCK,
      FIRST,
      SWING,
      'package.json',
    ]);
    expect(gitDoes('status', '--porcelain')).toBe('');
  });

  part('goes on with a branch whose nova is in the way', async () => {
    gitDoes('checkout', '-qb', 'nova');
    edit(SWING, '  "minerals": [', '  "novae": [\n    { "x": 740, "y": 490, "radius": 16 }\n  ],\n  "minerals": [');
    commit('a nova');
    const { stdout } = await gq('simulate', SWING, '--format', 'json');
    expect(JSON.parse(stdout)).toMatchObject({ outcome: 'collided', with: { kind: 'nova', index: 0 } });
    deadly = JSON.parse(stdout).tick;
    expect(deadly).toBeGreaterThan(100);
  });

  part('which CI refuses, and says where and what', async () => {
    const { status, stdout, summary, output } = ci({
      reporters: 'github\njson=reports/gq.json',
      junit: 'reports/gq.xml',
      sarif: 'reports/gq.sarif',
      lock: LOCK,
    });
    expect(status).toBe(1);
    expect(output).toMatch(/^exit-code=1$/m);
    expect(output).toMatch(/^sarif=reports\/gq\.sarif$/m);

    const line = lineOfSolution();
    const annotations = annotationsIn(stdout);
    expect(annotations.map(({ file }) => file)).toEqual(annotations.map(() => SWING));
    const [collision] = annotations;
    expect(collision).toMatchObject({ severity: 'error', title: 'run-does-not-complete', line: String(line) });
    expect(collision.message).toContain(`run "solution" does not complete the level under precise: collided with nova 1 at`);
    expect(collision.message).toContain(`(tick ${deadly})`);
    expect(collision.message).toContain(`gq edit --open ${SWING}:${deadly}`);
    const changed = annotations.filter(({ title }) => title === 'result-changed');
    expect(changed).toHaveLength(1);
    expect(changed[0]).toMatchObject({ severity: 'error', line: String(line) });
    expect(changed[0].message).toMatch(
      new RegExp(`^broken, before completable; collided at tick ${deadly}, before completed at tick 673; `),
    );

    expect(summary).toMatch(/1 of 2 levels fails/);
    expect(summary).toContain(`| ❌ broken | \`${SWING}\` | First Swing | run "solution" does not complete`);

    const junit = read('reports/gq.xml');
    expect(junit).toMatch(/<testsuites [^>]*tests="2" failures="1" errors="0"/);
    const failures = [...junit.matchAll(/<failure message="([^"]*)"[^>]*>([^<]*)<\/failure>/g)];
    expect(failures).toHaveLength(1);
    expect(failures[0][1]).toMatch(
      new RegExp(`^broken: run &quot;solution&quot; does not complete .*collided with nova 1 .*\\(tick ${deadly}\\)$`),
    );
    expect(failures[0][2]).toContain(`gq edit --open ${SWING}:${deadly}`);

    const json = readJson('reports/gq.json');
    expect(json).toMatchObject({ version: 1, summary: { completable: 1, broken: 1 } });
    const { problems } = json.levels[1];
    expect(problems[0]).toMatchObject({ code: 'run-does-not-complete', line, pointer: '/runs/0' });

    const { results } = readJson('reports/gq.sarif').runs[0];
    expect(results.map(({ ruleId }: { ruleId: string }) => ruleId)).toEqual(problems.map(({ code }: { code: string }) => code));
    expect(results[0].locations[0].physicalLocation).toMatchObject({
      artifactLocation: { uri: SWING },
      region: { startLine: line, startColumn: problems[0].column },
    });
    const fingerprints = results.map((result: { partialFingerprints: Record<string, string> }) =>
      JSON.stringify(result.partialFingerprints),
    );
    expect(new Set(fingerprints).size).toBe(results.length);
    expect(fingerprints[0]).toMatch(/"primaryLocationLineHash":"[0-9a-f]{32}:1"/);
  });

  part('also from a folder in the workspace, with the same places', async () => {
    const there = ci({
      'working-directory': 'levels',
      reporters: 'github',
      sarif: '../reports/below.sarif',
      lock: `../${LOCK}`,
      changed: 'main',
    });
    expect(there.status).toBe(1);
    const annotations = annotationsIn(there.stdout);
    expect(annotations[0]).toMatchObject({ file: SWING, line: String(lineOfSolution()), title: 'run-does-not-complete' });
    expect(annotations.map(({ title }) => title)).toContain('result-changed');
    expect(there.summary).toContain('02-first-swing.level.json`');
    // fingerprints belong to the file, not to the working directory
    expect(readJson('reports/below.sarif').runs[0].results).toHaveLength(readJson('reports/gq.sarif').runs[0].results.length);
    const fingerprint = (name: string) => readJson(name).runs[0].results[0].partialFingerprints;
    expect(fingerprint('reports/below.sarif')).toEqual(fingerprint('reports/gq.sarif'));
    // only the level that the branch changes
    expect((await verdicts('--changed=main')).levels).toMatchObject([{ file: SWING, verdict: 'broken' }]);
  });

  part('is seen in words, on a page and in git diff', async () => {
    const { code, stdout } = await gq('diff', 'main');
    expect(code).toBe(0);
    expect(stdout).toContain('nova 1 added at (740, 490)');
    expect(stdout).toContain('completable -> broken');
    expect(stdout).toMatch(/run "solution" now collides with nova 1 at \d+\.\d\d s/);
    const seconds = Number(/nova 1 at (\S+) s/.exec(stdout)?.[1]);
    expect(Math.abs(seconds * 60 - deadly)).toBeLessThan(1.5);
    expect(stdout).not.toContain('First Pull');

    const page = (await gq('diff', 'main', '--format', 'html')).stdout;
    expect(page).toMatch(/^<!doctype html>/i);
    expect(page).toContain('First Swing');
    // nothing is loaded from elsewhere
    expect(
      page.match(/<(?:link|img|iframe|script)\b[^>]*\b(?:src|href)="(?!data:|#)[^"]*"|@import|url\((?!["']?(?:data:|#))/gi),
    ).toBeNull();

    expect(gitDoes('diff', 'main', '--', SWING)).toMatch(/^\+nova at \(740, 490\), radius 16 px$/m);
  });

  part('leads from the red line to the place in the editor', async () => {
    const { stdout } = await gq('check', '--format', 'github', '--editor-url', 'https://example.org/editor/');
    expect(stdout).toContain('https://example.org/editor/#');
    const open = /gq (edit --open \S+:\d+)/.exec(stdout)?.[1].split(' ') ?? [];
    expect(open).toEqual(['edit', '--open', `${SWING}:${deadly}`]);
    // as a person gives it, but without a browser
    const editor = await gqEdit([...open.slice(1), '--port', '0'], { cwd: root, env: { BROWSER: 'none' } });
    const place = new URLSearchParams(new URL(editor.address).hash.slice(1));
    const page = await fetch(editor.address);
    expect(await editor.end('SIGINT')).toEqual({ code: 130, signal: null });
    expect(page.status).toBe(200);
    expect(Object.fromEntries(place)).toMatchObject({ level: '02-first-swing.level.json', tick: String(deadly) });
  });

  part('ends in the mend, and CI is green', async () => {
    edit(SWING, '"x": 740, "y": 490', '"x": 700, "y": 690');
    commit('the nova out of the way');
    const { status, stdout, summary } = ci({ lock: LOCK });
    expect([status, annotationsIn(stdout)]).toEqual([0, []]);
    expect(summary).not.toContain('❌');
    expect(gitDoes('status', '--porcelain')).toBe('');
  });

  part('merges what main has meanwhile, and loses nothing', async () => {
    gitDoes('checkout', '-q', 'main');
    edit(SWING, '"x": 512, "y": 580', '"x": 513, "y": 581');
    const added = '    {\n      "name": "a tick later",\n      "holds": [\n        [150, 436]\n      ]\n    },\n';
    edit(SWING, '  "runs": [\n', `  "runs": [\n${added}`);
    // another run comes first now, and the lock has the first one
    expect((await gq('check', '--lock', LOCK, '--update-lock')).code).toBe(0);
    commit('a run, and a mineral moved');
    gitDoes('merge', '-q', '--no-edit', 'nova');
    expect(levelIn(SWING)).toMatchObject({
      novae: [{ x: 700, y: 690, radius: 16 }],
      minerals: [{ id: 'ep2h', x: 513, y: 581 }, { id: 'gg6p' }, { id: 'zzvk' }],
      runs: [{ name: 'a tick later' }, { name: 'solution' }, { name: 'all-minerals' }],
    });
    expect(levelIn(SWING).conflicts).toBeUndefined();
    expect((await gq('fmt', '--check')).code).toBe(0);
    expect(await verdicts('--lock', LOCK)).toMatchObject(GREEN);
    expect(gitDoes('status', '--porcelain')).toBe('');
  });

  part('plays the runs again: two changes that are right alone break the level together', async () => {
    // on one side everything is mirrored at her height; on the other a nova lies where nobody flies, before the mirror
    gitDoes('checkout', '-qb', 'mirror');
    edit(FIRST, '"x": 620, "y": 560', '"x": 620, "y": 720');
    edit(FIRST, '"x": 830, "y": 440', '"x": 830, "y": 840');
    expect(await verdicts()).toMatchObject(GREEN);
    commit('mirrored');
    gitDoes('checkout', '-q', 'main');
    edit(FIRST, '  "runs": [', '  "novae": [\n    { "x": 719, "y": 776, "radius": 16 }\n  ],\n  "runs": [');
    expect(await verdicts('--lock', LOCK)).toMatchObject(GREEN);
    commit('a nova aside');
    const { status, said } = git('merge', '--no-edit', 'mirror');
    expect(status).toBe(1);
    const dies = /01-first-pull\.level\.json: merged, and the run "solution" now dies at tick (\d+), at nova 1 /.exec(said);
    const { stdout } = await gq('simulate', FIRST, '--format', 'json');
    expect(JSON.parse(stdout)).toMatchObject({ outcome: 'collided', tick: Number(dies?.[1]) });
    expect(levelIn(FIRST)).toMatchObject({ asteroids: [{ y: 720 }], blackHole: { y: 840 }, novae: [{ y: 776 }] });
    gitDoes('merge', '--abort');
    expect(await verdicts('--lock', LOCK)).toMatchObject(GREEN);
  });

  part('leaves a conflict to a person, in a valid file', async () => {
    gitDoes('checkout', '-qb', 'lower');
    edit(SWING, '"y": 690', '"y": 710');
    commit('lower');
    gitDoes('checkout', '-q', 'main');
    edit(SWING, '"y": 690', '"y": 720');
    commit('lower still');
    const { status, said } = git('merge', '--no-edit', 'lower');
    expect(status).toBe(1);
    expect(said).toMatch(/02-first-swing\.level\.json: 1 conflict: nova .*, place; our values stand in the file/);
    expect(read(SWING)).not.toContain('<<<<<<<');
    const level = levelIn(SWING);
    expect(level).toMatchObject({ novae: [{ y: 720 }], conflicts: [{ ours: { y: 720 }, theirs: { y: 710 } }] });
    const { code, levels, problems } = await verdicts();
    expect([code, levels.map(({ verdict }) => verdict)]).toEqual([1, ['completable', 'invalid']]);
    expect(problems.map(({ code }) => code)).toEqual(['merge-conflict']);
    expect(
      linesOf(SWING)
        .slice(problems[0].line - 1, problems[0].line + 3)
        .join('\n'),
    ).toContain('novae/');

    // the person decides for theirs
    const decided = readJson(SWING);
    delete decided.conflicts;
    decided.novae[0].y = 710;
    writeFileSync(at(SWING), JSON.stringify(decided));
    expect((await gq('fmt')).code).toBe(0);
    expect(await verdicts('--lock', LOCK)).toMatchObject(GREEN);
    commit('both, theirs in doubt');
    expect(gitDoes('rev-list', '--parents', '-1', 'HEAD').trim().split(' ')).toHaveLength(3);
    expect(gitDoes('diff', 'HEAD^', '--', SWING)).toMatch(/^\+nova \w+ at \(700, 710\), radius 16 px$/m);
  });

  part('agrees anew on what is changed on purpose', async () => {
    edit(FIRST, '[20, 120]', '[25, 125]');
    const { code, problems } = await verdicts('--lock', LOCK);
    expect(code).toBe(1);
    expect(problems).toMatchObject([{ code: 'result-changed', severity: 'error' }]);
    // pressed five ticks later, she arrives five ticks later
    expect(problems[0].message).toContain('completed at tick 985, before 980');
    const { stderr } = await gq('check', '--lock', LOCK, '--update-lock');
    expect(stderr).toContain(`${LOCK}: agreed anew: 1 changed`);
    const changes = gitDoes('diff', '-U0', '--', LOCK)
      .split('\n')
      .slice(4)
      .filter((line) => /^[-+]/.test(line));
    expect(changes.map((line) => line.slice(0, 60))).toEqual([
      expect.stringContaining('-    "levels/01-first-pull.level.json"'),
      expect.stringContaining('+    "levels/01-first-pull.level.json"'),
    ]);
    expect(await verdicts('--lock', LOCK)).toMatchObject(GREEN);
    commit('five ticks later');
  });

  part('and ends green from the cache', async () => {
    const args = ['check', '--lock', LOCK, '--format', 'json'];
    const cache = at('node_modules/.cache/gq');
    const kept = () => readdirSync(cache).map((name) => [name, readFileSync(join(cache, name), 'latin1')]);
    const played = async (...command: string[]) => {
      const { called, loaded: _, ...ended } = await gqCovered(command, root);
      return { ...ended, compiled: called.has('compile'), simulated: called.has('simulate') };
    };
    const before = kept();
    const known = await played(...args);
    expect(known).toMatchObject({ code: 0, stderr: '', compiled: false, simulated: false });
    expect(kept()).toEqual(before);
    const computed = await gq(...args, '--no-cache');
    const withoutTimes = (text: string): string => text.replace(/"ms":[\d.e-]+/g, '"ms":0');
    expect(computed).toMatchObject({ code: 0, stderr: '' });
    expect(withoutTimes(known.stdout)).toBe(withoutTimes(computed.stdout));
    // one byte more in a level, and it is played again
    appendFileSync(at(FIRST), '\n');
    expect(await played('check', FIRST)).toMatchObject({ code: 0, compiled: true, simulated: true });
  });
});
