import { createHmac } from 'node:crypto';
import {
  chmodSync,
  chownSync,
  lstatSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { createAccess, keptKey, newKey } from '../../cli/serve/access.ts';
import { EDIT_API, keyResponseSchema, runMessage, runResponseSchema, tokenMessage } from '../../schema/index.ts';
import { levelText, makeFolder, serve } from './running.ts';

const before = process.env.XDG_STATE_HOME;
let state: string;
const keys = () => join(state, 'gravity-quest-toolkit', 'edit-keys');
const fileOf = (folder: string) => join(keys(), folder);
const bits = (path: string) => lstatSync(path).mode & 0o777;
beforeEach(() => {
  state = mkdtempSync(join(tmpdir(), 'gq-state-'));
  process.env.XDG_STATE_HOME = state;
});
afterEach(() => {
  process.env.XDG_STATE_HOME = before;
  rmSync(state, { recursive: true, force: true });
});

const sign = (key: string, message: string) => createHmac('sha256', key).update(message).digest('base64url');
const CHALLENGE = 'c'.repeat(43);

describe.runIf(process.platform !== 'win32')('the key of a folder', () => {
  it('is the same in each run, another one for each folder, and only its owner can read it', () => {
    const umask = process.umask(0);
    try {
      const one = keptKey('one');
      expect(one).toEqual({ key: expect.stringMatching(/^[\w-]{43}$/), problem: null });
      expect(keptKey('one')).toEqual(one);
      expect(keptKey('two').key).not.toBe(one.key);
      expect(readdirSync(keys()).sort()).toEqual(['one', 'two']);
      expect([bits(keys()), bits(fileOf('one'))]).toEqual([0o700, 0o600]);
      expect(readFileSync(fileOf('one'), 'utf8')).toBe(`${one.key}\n`);
    } finally {
      process.umask(umask);
    }
  });

  it('is made anew where others could read it, or its file has anything else', () => {
    const { key } = keptKey('one');
    for (const mode of [0o640, 0o604, 0o620, 0o602]) {
      chmodSync(fileOf('one'), mode);
      const next = keptKey('one');
      expect([mode, next.problem, next.key === key, bits(fileOf('one'))]).toEqual([mode, null, false, 0o600]);
    }
    for (const text of ['', 'short\n', `${key}`, `${key}\n\n`, `${key}x\n`, `${'!'.repeat(43)}\n`]) {
      writeFileSync(fileOf('one'), text);
      const next = keptKey('one');
      expect([text, next.problem, readFileSync(fileOf('one'), 'utf8')]).toEqual([text, null, `${next.key}\n`]);
    }
  });

  it('is not taken through a link or from something else than a file, and nothing is written there', () => {
    const { key } = keptKey('one');
    renameSync(fileOf('one'), join(state, 'elsewhere'));
    symlinkSync(join(state, 'elsewhere'), fileOf('one'));
    const linked = keptKey('one');
    expect([linked.problem, linked.key === key]).toEqual([expect.stringMatching(/one is not a regular file/), false]);
    expect(readFileSync(join(state, 'elsewhere'), 'utf8')).toBe(`${key}\n`);
    expect(lstatSync(fileOf('one')).isSymbolicLink()).toBe(true);
    rmSync(fileOf('one'));
    mkdirSync(fileOf('one'));
    expect(keptKey('one').problem).toMatch(/one is not a regular file/);
  });

  it('is not kept in a folder that is a link, or that others can write into', () => {
    keptKey('one');
    chmodSync(keys(), 0o777);
    expect(keptKey('one').problem).toMatch(/other users can write into/);
    chmodSync(keys(), 0o700);
    renameSync(keys(), join(state, 'moved'));
    symlinkSync(join(state, 'moved'), keys());
    expect(keptKey('one').problem).toMatch(/edit-keys is not a folder/);
    rmSync(keys());
    rmSync(state, { recursive: true });
    writeFileSync(state, 'a file');
    expect(keptKey('one').problem).not.toBeNull();
  });

  it.runIf(process.getuid?.() === 0)('is not taken from another user', () => {
    const { key } = keptKey('one');
    chownSync(fileOf('one'), 65534, 65534);
    const foreign = keptKey('one');
    expect([foreign.problem, foreign.key === key]).toEqual([expect.stringMatching(/one belongs to another user/), false]);
    rmSync(fileOf('one'));
    chownSync(keys(), 65534, 65534);
    expect(keptKey('one').problem).toMatch(/edit-keys belongs to another user/);
  });
});

describe('a run', () => {
  it('has a token of its own, which only the key gives, and proves the key for its port and one question only', () => {
    const text = fc.stringMatching(/^[\w-]{22,64}$/);
    const port = fc.integer({ min: 1, max: 65_535 });
    fc.assert(
      fc.property(text, text, port, port, (challenge, other, here, there) => {
        const key = newKey();
        const [one, two] = [createAccess(key), createAccess(key)];
        expect(one.token).not.toBe(two.token);
        const { nonce, proof } = one.run(here, challenge);
        expect(sign(key, tokenMessage(nonce))).toBe(one.token);
        expect(sign(key, runMessage(here, challenge, nonce))).toBe(proof);
        expect(sign(newKey(), runMessage(here, challenge, nonce))).not.toBe(proof);
        expect(sign(key, runMessage(there, challenge, nonce)) === proof).toBe(there === here);
        expect(sign(key, runMessage(here, other, nonce)) === proof).toBe(other === challenge);
        expect(proof).not.toBe(one.token);
      }),
    );
  });

  it('tells which one it is without a token, and its key only with one; the next run has the same key', async () => {
    const made = makeFolder({ 'a.level.json': levelText('a') });
    const first = await serve(made.folder);
    const ask = (server: typeof first, path: string, headers = {}) => server.page.send('GET', path, undefined, headers);
    const bare = { [EDIT_API.TOKEN_HEADER]: undefined };
    const { key } = keyResponseSchema.parse((await ask(first, EDIT_API.KEY)).json());
    expect((await ask(first, EDIT_API.KEY, bare)).status).toBe(401);
    const answer = await ask(first, `${EDIT_API.RUN}?challenge=${CHALLENGE}`, bare);
    expect(answer.status).toBe(200);
    const run = runResponseSchema.parse(answer.json());
    expect(sign(key, tokenMessage(run.nonce))).toBe(first.page.token);
    expect(sign(key, runMessage(first.page.port, CHALLENGE, run.nonce))).toBe(run.proof);
    expect(answer.text).not.toContain(first.page.token);
    expect(answer.text).not.toContain(key);
    for (const challenge of [
      '',
      '?challenge=',
      '?challenge=short',
      `?challenge=${'c'.repeat(65)}`,
      `?challenge=${'%0a'.repeat(30)}`,
    ])
      expect([challenge, (await ask(first, `${EDIT_API.RUN}${challenge}`, bare)).status]).toEqual([challenge, 400]);
    // as with everything else, only its own page may ask
    const foreign = { ...bare, Origin: 'https://evil.example' };
    expect((await ask(first, `${EDIT_API.RUN}?challenge=${CHALLENGE}`, foreign)).status).toBe(403);
    const rebound = { ...bare, Host: 'evil.example' };
    expect((await ask(first, `${EDIT_API.RUN}?challenge=${CHALLENGE}`, rebound)).status).toBe(403);
    await first.close();

    const second = await serve(made.folder);
    expect(second.page.token).not.toBe(first.page.token);
    expect(keyResponseSchema.parse((await ask(second, EDIT_API.KEY)).json()).key).toBe(key);
    expect((await ask(second, EDIT_API.LEVELS, { [EDIT_API.TOKEN_HEADER]: first.page.token })).status).toBe(401);
    expect((await ask(second, EDIT_API.LEVELS, { [EDIT_API.TOKEN_HEADER]: key })).status).toBe(401);
    await second.close();
    made.remove();
  });
});
