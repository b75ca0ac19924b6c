import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parse } from 'yaml';
import { fallThrough, gq, makeFiles } from '../cli/gq.ts';
import { type Commands, readCommands, wordsOf } from '../docs/terminal.ts';
import { makeProject, ofPackage, runIn } from './project.ts';

interface Pattern {
  readonly regexp: string;
  readonly file: number;
  readonly line?: number;
  readonly column?: number;
  readonly severity: number;
  readonly code: number;
  readonly message: number;
}

const matchers: readonly { owner: string; pattern: Pattern[] }[] = JSON.parse(
  ofPackage('templates/problem-matcher.json'),
).problemMatcher;
const tasks = JSON.parse(ofPackage('templates/vscode/tasks.json')).tasks;
const gitlab = parse(ofPackage('templates/gitlab-ci.yml'));

/** What a matcher finds in a log, a line at a time. */
function found(pattern: Pattern, log: string) {
  return log.split('\n').flatMap((text) => {
    const match = new RegExp(pattern.regexp).exec(text);
    if (match === null) return [];
    const part = (group: number | undefined): string | null => (group === undefined ? null : match[group]);
    return [
      [part(pattern.file), part(pattern.line), part(pattern.column), part(pattern.severity), part(pattern.code)].join(' | '),
    ];
  });
}

let commands: Commands;
beforeAll(async () => {
  commands = await readCommands();
});

describe('the problem matcher', () => {
  const files = makeFiles({
    'levels/my level: 2.level.json': '{\n  "version": 1,\n  "nam": "error x: y"\n}',
    'levels/no-run.level.json': fallThrough({ runs: [] }),
    'levels/fine.level.json': fallThrough(),
    'levels/a-warning.level.json': fallThrough({ 'x-note': 1, novae: [{ x: 5000, y: 0, radius: 16 }] }),
  });
  afterAll(files.remove);

  it('finds every problem of a report for people with its place, and nothing else', async () => {
    const report = JSON.parse((await gq(['check', '--format', 'json'], { cwd: files.directory })).stdout);
    const { stdout } = await gq(['check'], { cwd: files.directory });
    type Problem = { line: number | null; column: number | null; severity: string; code: string };
    const problems = report.levels.flatMap(({ file, problems }: { file: string; problems: Problem[] }) =>
      problems.map(({ line, column, severity, code }) => ({ line, text: [file, line, column, severity, code].join(' | ') })),
    );
    const [placed, whole] = [matchers[0].pattern[0], matchers[1].pattern[0]];
    const texts = (hasPlace: boolean) =>
      problems
        .filter(({ line }: { line: number | null }) => (line !== null) === hasPlace)
        .map(({ text }: { text: string }) => text);
    expect(texts(true).length).toBeGreaterThan(1);
    expect(texts(false).length).toBeGreaterThan(0);
    expect(found(placed, stdout)).toEqual(texts(true));
    expect(found(whole, stdout)).toEqual(texts(false));
    expect(found(placed, 'C:\\my games\\a.level.json:3:14: error wrong-type: x: expected a number')).toEqual([
      'C:\\my games\\a.level.json | 3 | 14 | error | wrong-type',
    ]);
  });

  it('is the same in the task for VS Code, which runs a command that exists', () => {
    expect(tasks[0].problemMatcher.pattern).toEqual(matchers[0].pattern[0]);
    expect(commands.problemOf(wordsOf(tasks[0].command.replace('npx --no-install gq ', '')))).toBeNull();
    expect(new Set(matchers.map(({ owner }) => owner)).size).toBe(matchers.length);
  });
});

describe('the job for GitLab', () => {
  const script: readonly string[] = gitlab.levels.script;

  it('runs commands with options that exist', () => {
    const calls = script.filter((line) => line.includes(' gq '));
    expect(calls.length).toBeGreaterThan(1);
    for (const line of calls) expect(commands.problemOf(wordsOf(line.replace('npx --no-install gq ', ''))), line).toBeNull();
  });

  it('writes the report that it keeps, also of a check that fails', () => {
    const project = makeProject({ 'levels/bad.level.json': '{' }, 'real');
    const [check] = script.filter((line) => line.includes(' gq check'));
    const { status } = runIn(project.directory, 'sh', ['-ec', check]);
    const report = gitlab.levels.artifacts.reports.junit;
    expect(gitlab.levels.artifacts.when).toBe('always');
    expect(readFileSync(join(project.directory, report), 'utf8')).toMatch(/<testsuite [\s\S]*levels\/bad\.level\.json/);
    expect(status).toBe(1);
    project.remove();
  });

  it('runs when levels, rules or the toolkit change', () => {
    const [request, branch] = gitlab.levels.rules;
    expect(request.changes).toEqual(branch.changes);
    expect(request.changes).toEqual(expect.arrayContaining(['**/*.level.json', '**/gq.config.json', '**/package-lock.json']));
  });
});

it('the settings for VS Code name schemas of the package', () => {
  const settings = JSON.parse(ofPackage('templates/vscode/settings.json'));
  const names = settings['json.schemas'].map(({ url }: { url: string }) =>
    url.replace('./node_modules/gravity-quest-toolkit/', ''),
  );
  const { files } = JSON.parse(ofPackage('package.json'));
  for (const name of names) {
    // the schema of the configuration is in the package as soon as there is one
    if (name === 'schema/config.schema.json' && !files.includes(name)) continue;
    expect(files).toContain(name);
    expect(existsSync(fileURLToPath(new URL(`../../${name}`, import.meta.url)))).toBe(true);
  }
  expect(files).toEqual(expect.arrayContaining(['templates', 'action.yml']));
});
