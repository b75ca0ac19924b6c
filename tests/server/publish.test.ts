import { existsSync, mkdirSync, readFileSync, realpathSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { EDIT_API, errorResponseSchema, formatLevel, type PublishRequest, publishResponseSchema } from '../../schema/index.ts';
import { fallThrough } from '../cli/gq.ts';
import { GRAZE, SLOW } from '../editor/terms-levels.ts';
import { everythingIn, makeFolder, serve } from './running.ts';

let made: ReturnType<typeof makeFolder>;
let server: Awaited<ReturnType<typeof serve>>;

beforeEach(async () => {
  made = makeFolder({
    'game/levels/1-good.level.json': fallThrough({ name: 'Good' }),
    'game/levels/2-unproven.level.json': fallThrough({ name: 'Unproven', runs: [] }),
    'game/levels/gq.config.json': '{ "rules": { "pull": 50 } }',
    'game/notes/mine.txt': 'mine',
    'outside/mine.txt': 'mine',
  });
  server = await serve(join(made.folder, 'game/levels'));
});
afterEach(async () => {
  expect(server.crashes).toEqual([]);
  await server.close();
  made.remove();
});

const publish = (more: Partial<PublishRequest> = {}, { page } = server) =>
  page.send('POST', EDIT_API.PUBLISH, {
    ...{ site: 'site', level: null, title: 'Mine', withRuns: true, force: false, client: 'page-1' },
    ...more,
  });
const refused = async (more: Partial<PublishRequest> = {}) => {
  const before = everythingIn(made.folder);
  const answer = await publish(more);
  expect(everythingIn(made.folder)).toEqual(before);
  return { status: answer.status, ...errorResponseSchema.parse(answer.json()).error };
};
const pack = (site = 'site') => readFileSync(join(made.folder, 'game', site, 'pack.js'), 'utf8');

describe('POST PUBLISH', () => {
  it('makes a page of one level beside the folder, under the rules of the folder, and again', async () => {
    const answer = await publish({ level: '1-good' });
    expect(answer.status, answer.text).toBe(200);
    const { site, levels, bytes } = publishResponseSchema.parse(answer.json());
    expect({ site: realpathSync(site), levels }).toEqual({ site: realpathSync(join(made.folder, 'game/site')), levels: 1 });
    expect(bytes).toBeGreaterThan(100_000);
    expect(pack()).toMatch(/"title": "Mine",.*"id":"1-good".*"rules":\{"pull":50\}.*"runs":/s);
    expect((await publish({ level: '1-good', withRuns: false, title: 'Other' })).status).toBe(200);
    expect(pack()).toContain('"title": "Other"');
    expect(pack()).not.toContain('"runs"');
  });

  it('judges levels under the terms of the folder', async () => {
    const levels = join(made.folder, 'game/levels');
    writeFileSync(join(levels, 'graze.level.json'), formatLevel(GRAZE));
    writeFileSync(join(levels, 'slow.level.json'), formatLevel(SLOW));
    const statusOf = async (level: string, terms: object) => {
      writeFileSync(join(levels, 'gq.config.json'), JSON.stringify(terms));
      return (await publish({ level })).status;
    };
    expect(await statusOf('graze', {})).toBe(200);
    expect(await statusOf('graze', { accuracy: 'arcade' })).toBe(409);
    expect(await statusOf('graze', { maxWork: 3 })).toBe(409);
    expect(await statusOf('slow', {})).toBe(409);
    expect(await statusOf('slow', { maxTime: 120 })).toBe(200);
  });

  it('makes one page after the other: two into one folder do not meet', async () => {
    const answers = await Promise.all([publish({ level: '1-good' }), publish({ level: '1-good', title: 'Other' })]);
    expect(answers.map(({ status }) => status)).toEqual([200, 200]);
  });

  it('says where the page is when the folder of the levels was opened through a link', async () => {
    symlinkSync('game/levels', join(made.folder, 'linked'));
    const linked = await serve(join(made.folder, 'linked'));
    try {
      const { site } = publishResponseSchema.parse((await publish({ level: '1-good' }, linked)).json());
      expect(existsSync(join(made.folder, 'game/site/index.html'))).toBe(true);
      expect(realpathSync(site)).toBe(realpathSync(join(made.folder, 'game/site')));
    } finally {
      await linked.close();
    }
  });

  it('names the levels that are not known to be completable, and publishes them only when it is told to', async () => {
    expect(await refused()).toMatchObject({
      status: 409,
      code: 'not-completable',
      message: expect.stringContaining('1 of 2 levels'),
      levels: [{ id: '2-unproven', name: 'Unproven', verdict: 'unproven', message: expect.stringContaining('no run') }],
    });
    expect((await publish({ force: true })).status).toBe(200);
    expect(pack()).toMatch(/"id":"1-good".*\n.*"id":"2-unproven"/);
  });

  it('says in words what is wrong with the order of the levels: the page has no room for lines of a terminal', async () => {
    const order = { version: 1, name: 'pack', levels: ['1-good', 'missing'] };
    writeFileSync(join(made.folder, 'game/levels/pack.json'), JSON.stringify(order, null, 2));
    const error = await refused();
    expect(error).toMatchObject({
      status: 409,
      code: 'not-published',
      message: 'nothing was written, because of errors in the order of the levels',
      files: [
        {
          file: expect.stringMatching(/levels.pack\.json$/),
          problems: [expect.objectContaining({ message: 'there is no level "missing" in this folder', line: 6, column: 5 })],
        },
      ],
    });
    expect(JSON.stringify(error)).not.toContain('\\n');
  });

  it('never publishes an invalid level', async () => {
    writeFileSync(join(made.folder, 'game/levels/3.level.json'), '{');
    expect(await refused({ force: true })).toMatchObject({ status: 409, levels: [{ id: '3', verdict: 'invalid' }] });
  });

  it.each(['../site', '/tmp/site', '.', '..', 'a/b', 'a\\b', 'con', 'levels', 'Levels', '.git'])(
    'refuses the name %s: it is no name of a new folder beside the levels',
    async (site) => {
      expect(await refused({ site, level: '1-good' })).toMatchObject({ status: 400 });
    },
  );

  it('leaves folders of others alone, and does not follow links', async () => {
    expect(await refused({ site: 'notes', level: '1-good' })).toMatchObject({
      status: 409,
      code: 'not-published',
      message: expect.stringMatching(/not empty \(mine\.txt\).*choose another name$/),
    });
    mkdirSync(join(made.folder, 'empty'));
    symlinkSync('../empty', join(made.folder, 'game/linked'));
    expect(await refused({ site: 'linked', level: '1-good' })).toMatchObject({ status: 409, code: 'not-published' });
  });

  it('knows only levels of the list, and says what else is wrong', async () => {
    expect(await refused({ level: '../levels/1-good' })).toMatchObject({ status: 404 });
    expect(await refused({ title: '' })).toMatchObject({ status: 400 });
    writeFileSync(join(made.folder, 'game/levels/gq.config.json'), '{ "rulez": 1 }');
    expect(await refused({ level: '1-good' })).toMatchObject({
      status: 409,
      message: 'nothing was done: the configuration is not valid',
      files: [
        {
          file: expect.stringMatching(/gq\.config\.json$/),
          problems: [expect.objectContaining({ message: expect.stringContaining('rulez'), line: 1, column: 3 })],
        },
      ],
    });
    expect(existsSync(join(made.folder, 'game/site'))).toBe(false);
  });
});
