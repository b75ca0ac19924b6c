import { mkdirSync, symlinkSync } from 'node:fs';
import { connect } from 'node:net';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { EDIT_API, errorResponseSchema } from '../../schema/index.ts';
import { type Asked, everythingIn, levelPath, levelText, makeFolder, put, serve } from './running.ts';

// What websites, and files in a shared level folder, could try against a server on the user's own machine. Each attack gets a
// 4xx and changes nothing in the folder or around it.

let around: ReturnType<typeof makeFolder>;
let folder: string;
let server: Awaited<ReturnType<typeof serve>>;
let tag = '';
let before: ReturnType<typeof everythingIn>;
beforeAll(async () => {
  around = makeFolder({
    'secret.level.json': levelText('secret'),
    'levels/a.level.json': levelText('a'),
    'levels/sub/b.level.json': levelText('b'),
    'levels/broken.level.json': '{',
    'elsewhere/c.level.json': levelText('c'),
  });
  folder = join(around.folder, 'levels');
  symlinkSync('../secret.level.json', join(folder, 'link.level.json'));
  symlinkSync('../elsewhere', join(folder, 'out'));
  symlinkSync('sub', join(folder, 'in'));
  mkdirSync(join(folder, '.hidden'));
  put(folder, '.hidden/h.level.json', levelText('h'));
  server = await serve(folder);
  tag = (await server.page.get(levelPath('a'))).headers.etag as string;
  before = everythingIn(around.folder);
});
afterAll(async () => {
  expect(server.crashes).toEqual([]);
  await server.close();
  around.remove();
});

const text = levelText('evil');
const client = 'attacker';
const body = JSON.stringify({ text, client });
const put412 = { method: 'PUT', path: levelPath('a'), body } satisfies Asked;
const overwrite = (): Asked => ({ ...put412, headers: { 'If-Match': tag } });
const withHeaders = (headers: Asked['headers']): Asked => ({ ...overwrite(), headers: { 'If-Match': tag, ...headers } });
const port = (): number => server.port;

const large = (bytes: number): string => {
  const empty = JSON.stringify({ text: '', client });
  return JSON.stringify({ text: 'x'.repeat(bytes - empty.length), client });
};

type Attack = [name: string, status: number, attack: () => Asked];

const foreign: Attack[] = [
  // CVE-2025-24964, CVE-2026-27148: requests that a form or a simple request of a foreign page can send
  [
    'a foreign page posts text/plain',
    403,
    () => ({
      ...withHeaders({ Origin: 'https://evil.example', 'Content-Type': 'text/plain', 'Sec-Fetch-Site': 'cross-site' }),
      method: 'POST',
    }),
  ],
  ['... with an old browser', 403, () => withHeaders({ Origin: 'https://evil.example', 'Sec-Fetch-Site': undefined })],
  ['... puts JSON, with the token', 403, () => withHeaders({ Origin: 'https://evil.example' })],
  ['a page without an origin', 403, () => withHeaders({ Origin: 'null' })],
  ['a change without Origin', 403, () => withHeaders({ Origin: undefined })],
  ['two origins', 403, () => withHeaders({ Origin: [`http://127.0.0.1:${port()}`, 'https://evil.example'] })],
  ['another port of this machine', 403, () => withHeaders({ Origin: 'http://127.0.0.1:3000', 'Sec-Fetch-Site': 'same-site' })],
  ['another port, by Sec-Fetch-Site alone', 403, () => withHeaders({ 'Sec-Fetch-Site': 'same-site' })],
  ['https in its place', 403, () => withHeaders({ Origin: `https://127.0.0.1:${port()}` })],
  ['the other name of this server', 403, () => withHeaders({ Origin: `http://localhost:${port()}` })],
  ['an origin that begins like ours', 403, () => withHeaders({ Origin: `http://127.0.0.1:${port()}.evil.example` })],
  [
    'a foreign page reads',
    403,
    () => ({ path: EDIT_API.LEVELS, headers: { Origin: undefined, 'Sec-Fetch-Site': 'cross-site' } }),
  ],
  [
    'a foreign page reads, with its origin',
    403,
    () => ({ path: EDIT_API.LEVELS, headers: { Origin: 'https://evil.example', 'Sec-Fetch-Site': undefined } }),
  ],
  ['a foreign page listens', 403, () => ({ path: EDIT_API.EVENTS, headers: { Origin: 'https://evil.example' } })],
  [
    'a foreign page leads to the API',
    403,
    () => ({
      path: EDIT_API.LEVELS,
      headers: { Origin: undefined, 'Sec-Fetch-Site': 'cross-site', 'Sec-Fetch-Mode': 'navigate', 'Sec-Fetch-Dest': 'document' },
    }),
  ],
  [
    'a foreign page puts ours into a frame',
    403,
    () => ({
      headers: { Origin: undefined, 'Sec-Fetch-Site': 'cross-site', 'Sec-Fetch-Mode': 'navigate', 'Sec-Fetch-Dest': 'iframe' },
    }),
  ],
  [
    'a foreign page loads a script of ours',
    403,
    () => ({
      path: '/assets/index-abc.js',
      headers: { Origin: undefined, 'Sec-Fetch-Site': 'cross-site', 'Sec-Fetch-Mode': 'no-cors', 'Sec-Fetch-Dest': 'script' },
    }),
  ],
  [
    'a foreign form leads to our page',
    403,
    () => ({
      method: 'POST',
      headers: {
        Origin: 'https://evil.example',
        'Sec-Fetch-Site': 'cross-site',
        'Sec-Fetch-Mode': 'navigate',
        'Sec-Fetch-Dest': 'document',
      },
    }),
  ],
  [
    'a person types the address of the API',
    403,
    () => ({ path: EDIT_API.LEVELS, headers: { Origin: undefined, 'Sec-Fetch-Site': 'none' } }),
  ],
  [
    'a preflight',
    403,
    () => ({
      method: 'OPTIONS',
      path: levelPath('a'),
      headers: { Origin: 'https://evil.example', 'Access-Control-Request-Method': 'PUT', 'Sec-Fetch-Site': 'cross-site' },
    }),
  ],
  [
    'a preflight for a private network',
    403,
    () => ({
      method: 'OPTIONS',
      path: levelPath('a'),
      headers: {
        Origin: 'https://evil.example',
        'Access-Control-Request-Private-Network': 'true',
        'Sec-Fetch-Site': 'cross-site',
      },
    }),
  ],
];

const names: Attack[] = [
  // CVE-2025-24010: host names that resolve to 127.0.0.1 (DNS rebinding)
  ['a name of the attacker', 403, () => withHeaders({ Host: `evil.example:${port()}`, Origin: `http://evil.example:${port()}` })],
  ['a name that begins like ours', 403, () => withHeaders({ Host: `127.0.0.1.evil.example:${port()}` })],
  ['a name that ends like ours', 403, () => withHeaders({ Host: `evil.localhost:${port()}` })],
  ['another port', 403, () => withHeaders({ Host: '127.0.0.1:1' })],
  ['no port', 403, () => withHeaders({ Host: '127.0.0.1' })],
  ['the same address written otherwise', 403, () => withHeaders({ Host: `127.1:${port()}`, Origin: `http://127.1:${port()}` })],
  ['all addresses', 403, () => withHeaders({ Host: `0.0.0.0:${port()}`, Origin: `http://0.0.0.0:${port()}` })],
  ['a name and ours', 400, () => withHeaders({ Host: `evil.example@127.0.0.1:${port()}` })],
  [
    'another name of this machine forwarded',
    403,
    () => withHeaders({ Host: `evil.example:${port()}`, 'X-Forwarded-Host': `127.0.0.1:${port()}` }),
  ],
  ['a name for reading', 403, () => ({ path: EDIT_API.LEVELS, headers: { Host: `evil.example:${port()}` } })],
  ['a name for the page', 403, () => ({ headers: { Host: `evil.example:${port()}` } })],
];

const tokens: Attack[] = [
  ['no token', 401, () => withHeaders({ [EDIT_API.TOKEN_HEADER]: undefined })],
  ['an empty token', 401, () => withHeaders({ [EDIT_API.TOKEN_HEADER]: '' })],
  [
    'a wrong token',
    401,
    () => withHeaders({ [EDIT_API.TOKEN_HEADER]: server.page.token.replace(/^./, (c) => (c === 'A' ? 'B' : 'A')) }),
  ],
  ['a part of the token', 401, () => withHeaders({ [EDIT_API.TOKEN_HEADER]: server.page.token.slice(0, -1) })],
  ['the token twice', 401, () => withHeaders({ [EDIT_API.TOKEN_HEADER]: [server.page.token, server.page.token] })],
  [
    'the token in the address',
    401,
    () => ({ path: `${EDIT_API.LEVELS}?token=${server.page.token}`, headers: { [EDIT_API.TOKEN_HEADER]: undefined } }),
  ],
  [
    'the token in a cookie',
    401,
    () => ({ path: EDIT_API.LEVELS, headers: { [EDIT_API.TOKEN_HEADER]: undefined, Cookie: `token=${server.page.token}` } }),
  ],
  ...[EDIT_API.LEVELS, levelPath('a'), EDIT_API.TRASH, EDIT_API.EVENTS].map(
    (path): Attack => [`reading ${path} without a token`, 401, () => ({ path, headers: { [EDIT_API.TOKEN_HEADER]: undefined } })],
  ),
];

const shapes: Attack[] = [
  ...[
    'text/plain',
    'application/x-www-form-urlencoded',
    'multipart/form-data; boundary=x',
    'application/json; charset=utf-8',
    'application/json;charset=utf-16',
    'text/json',
    'application/json, text/plain',
    'APPLICATION/JSON',
  ].map((type): Attack => [`the content type ${type}`, 415, () => withHeaders({ 'Content-Type': type })]),
  ['no content type', 415, () => withHeaders({ 'Content-Type': undefined })],
  ['an encoded body', 415, () => withHeaders({ 'Content-Encoding': 'gzip' })],
  ['a body above 1 MiB', 413, () => ({ ...overwrite(), body: large(1024 * 1024 + 1) })],
  [
    'a body above 1 MiB that does not say so',
    413,
    () => ({ ...withHeaders({ 'Transfer-Encoding': 'chunked' }), body: large(1024 * 1024 + 1) }),
  ],
  ['a huge body', 413, () => ({ ...overwrite(), body: large(20 * 1024 * 1024) })],
  [
    'a huge body that does not say so',
    413,
    () => ({ ...withHeaders({ 'Transfer-Encoding': 'chunked' }), body: large(20 * 1024 * 1024) }),
  ],
  ['no JSON', 400, () => ({ ...overwrite(), body: 'text=evil' })],
  ['nothing', 400, () => ({ ...overwrite(), body: '' })],
  ['no UTF-8', 400, () => ({ ...overwrite(), body: Buffer.from([0x22, 0xff, 0x22]) })],
  ['nothing but brackets', 400, () => ({ ...overwrite(), body: '['.repeat(500_000) })],
  ['other keys', 400, () => ({ ...overwrite(), body: JSON.stringify({ text, client, path: '/etc/passwd' }) })],
  [
    'a prototype',
    400,
    () => ({ ...overwrite(), body: `{"__proto__":{"text":"x"},"text":${JSON.stringify(text)},"client":"c"}` }),
  ],
  ['a text that is none', 400, () => ({ ...overwrite(), body: JSON.stringify({ text: { toString: 1 }, client }) })],
  ['half a character', 400, () => ({ ...overwrite(), body: `{"text":"\\ud800","client":"c"}` })],
  ['a client with a line in it', 400, () => ({ ...overwrite(), body: JSON.stringify({ text, client: 'a\ndata: evil' }) })],
  ['no level', 422, () => ({ ...overwrite(), body: JSON.stringify({ text: '<script>', client }) })],
  [
    'a level with an error',
    422,
    () => ({ ...overwrite(), body: JSON.stringify({ text: text.replace('170', '"far"'), client }) }),
  ],
  ['an empty text', 422, () => ({ ...overwrite(), body: JSON.stringify({ text: '', client }) })],
];

const bases: Attack[] = [
  ['no base', 428, () => put412],
  ['any base', 428, () => withHeaders({ 'If-Match': '*' })],
  ['a weak base', 428, () => withHeaders({ 'If-Match': `W/${tag}` })],
  ['a base without quotes', 428, () => withHeaders({ 'If-Match': tag.slice(1, -1) })],
  ['a list of bases', 428, () => withHeaders({ 'If-Match': `"${'0'.repeat(64)}", ${tag}` })],
  ['two bases', 428, () => withHeaders({ 'If-Match': [tag, tag] })],
  ['a base and none', 428, () => withHeaders({ 'If-None-Match': '*' })],
  ['another base', 412, () => withHeaders({ 'If-Match': `"${'0'.repeat(64)}"` })],
  ['a new level in the place of an old one', 412, () => ({ ...put412, headers: { 'If-None-Match': '*' } })],
  ['a new level with an etag as its base', 428, () => ({ ...put412, headers: { 'If-None-Match': tag } })],
  ['deleting without a base', 428, () => ({ method: 'POST', path: EDIT_API.DELETE, body: JSON.stringify({ id: 'a', client }) })],
  [
    'renaming without a base',
    428,
    () => ({ method: 'POST', path: EDIT_API.RENAME, body: JSON.stringify({ id: 'a', to: 'z', client }) }),
  ],
  [
    'deleting on another base',
    412,
    () => ({
      method: 'POST',
      path: EDIT_API.DELETE,
      headers: { 'If-Match': `"${'0'.repeat(64)}"` },
      body: JSON.stringify({ id: 'a', client }),
    }),
  ],
];

const methods: Attack[] = [
  ...['POST', 'DELETE', 'PATCH', 'HEAD', 'OPTIONS', 'TRACE', 'PROPFIND'].map(
    (method): Attack => [`${method} in the place of PUT`, 405, () => ({ ...overwrite(), method, body: undefined })],
  ),
  ['another method by a header', 405, () => ({ ...withHeaders({ 'X-HTTP-Method-Override': 'PUT' }), method: 'POST' })],
  ['another method by a parameter', 400, () => ({ ...overwrite(), path: `${levelPath('a')}&_method=DELETE` })],
  ['POST to the page', 405, () => ({ method: 'POST', path: '/' })],
  [
    'WebSocket',
    400,
    () => ({
      path: EDIT_API.EVENTS,
      headers: {
        Upgrade: 'websocket',
        Connection: 'Upgrade',
        'Sec-WebSocket-Key': 'AAAAAAAAAAAAAAAAAAAAAA==',
        'Sec-WebSocket-Version': '13',
      },
    }),
  ],
  [
    'WebSocket from elsewhere',
    400,
    () => ({
      path: '/',
      headers: {
        Origin: 'https://evil.example',
        Upgrade: 'websocket',
        Connection: 'Upgrade',
        'Sec-Fetch-Site': 'cross-site',
        'Sec-Fetch-Mode': 'websocket',
        'Sec-WebSocket-Key': 'AAAAAAAAAAAAAAAAAAAAAA==',
        'Sec-WebSocket-Version': '13',
      },
    }),
  ],
  [
    'HTTP/2',
    400,
    () => ({ path: '/', headers: { Upgrade: 'h2c', Connection: 'Upgrade, HTTP2-Settings', 'HTTP2-Settings': '' } }),
  ],
  ['huge headers', 431, () => withHeaders({ 'X-Large': 'x'.repeat(20_000) })],
  ['no id', 400, () => ({ path: EDIT_API.LEVEL })],
  ['two ids', 400, () => ({ path: `${levelPath('a')}&id=broken` })],
  ['an empty id', 400, () => ({ path: `${EDIT_API.LEVEL}?id=` })],
];

/** Addresses that a careless server would turn into paths; none is served, with or without a token. */
const ADDRESSES = [
  '/../secret.level.json', '/levels/../../secret.level.json', '/%2e%2e/secret.level.json', '/..%2fsecret.level.json', '/..%5csecret.level.json',
  '/assets/..%2f..%2fpackage.json', '/assets/../index.html', '/assets//index-abc.js', '//127.0.0.1/index.html', '/assets/%69ndex-abc.js', '/assets/index-abc.js/',
  '/assets/index-abc.js%00.html', '/index.html%3f', '/.git/config', '/a.level.json', '/@fs/etc/passwd', '/@fs/etc/passwd?raw??', '/etc/passwd', '/C:/Windows/win.ini',
  '/api', '/api/', '/api/level/', '/api/levels/', '/api/LEVELS', '/api//levels', '/api/./levels', '/api/x/../levels', '/%61pi/levels', '/api%2flevels', '/api/levels%00', '/api/levels;x',
]; // biome-ignore format: a list

/** Ids that would lead a careless server out of the folder, or to files that are not in the list. */
const IDS = [
  '../secret', '..', '.', '../../secret', 'sub/../../secret', 'sub/../a', './a', 'a/', '/a', '//a', 'sub//b', 'a/../a', '..\\secret', 'sub\\b', '..%2fsecret', '%2e%2e%2fsecret', '..%252fsecret',
  '%2e%2e/secret', '....//secret', '..;/secret', '..\u2215secret', '\uff0e\uff0e/secret', '\uff0e\uff0e\uff0fsecret', '..\u0000/secret', 'a\u0000', 'a\u0000.level.json', 'secret\u0000/../a',
  'a.level.json', 'a.level', 'A ', 'a.', 'a::$DATA', 'a:stream', 'C:\\secret', 'file:///etc/passwd', '/etc/passwd', '\\\\server\\share\\a', '~/secret', '$HOME/a', '`a`', 'a\n', '\ra', 'a\u202e',
  'out/c', 'in/b', '.hidden/h', '.gq-trash/x', '.gitignore', 'con', 'nul.txt', 'COM1', '__proto__', 'x'.repeat(4000), 'x/'.repeat(500), '\u00e9', 'e\u0301', '*', '?', 'sub/*',
]; // biome-ignore format: a list

const tryAll = (attacks: Attack[]): void => {
  it.each(attacks)('%s: %i', async (_, status, attack) => {
    const answer = await server.page.ask(attack());
    expect(answer.status).toBe(status);
    expect(everythingIn(around.folder)).toEqual(before);
    expect(Object.keys(answer.headers).filter((name) => name.startsWith('access-control-'))).toEqual([]);
    if (status === 431 || answer.text === '') return;
    const { error } = errorResponseSchema.parse(answer.json());
    expect(error.message.length).toBeGreaterThan(10);
    expect(error.hint.length).toBeGreaterThan(5);
    expect(answer.headers).toMatchObject({
      'x-content-type-options': 'nosniff',
      'cache-control': 'no-store',
      'x-frame-options': 'DENY',
    });
  });
};

it('accepts the requests of the page itself, from which each attack differs in one thing', async () => {
  const same = JSON.stringify({ text: levelText('a'), client });
  expect((await server.page.ask({ ...overwrite(), body: same })).status).toBe(200);
  expect(
    (await server.page.ask({ ...withHeaders({ Host: `localhost:${port()}`, Origin: `http://localhost:${port()}` }), body: same }))
      .status,
  ).toBe(200);
  expect((await server.page.ask({ ...overwrite(), body: large(1024 * 1024) })).status).toBe(422);
  expect((await server.page.get(EDIT_API.LEVELS)).status).toBe(200);
  const typed = { Origin: undefined, 'Sec-Fetch-Site': 'none', [EDIT_API.TOKEN_HEADER]: undefined };
  expect((await server.page.ask({ headers: typed })).status).toBe(200);
  const linked = { ...typed, 'Sec-Fetch-Site': 'cross-site', 'Sec-Fetch-Mode': 'navigate', 'Sec-Fetch-Dest': 'document' };
  expect((await server.page.ask({ headers: linked })).status).toBe(200);
  expect(everythingIn(around.folder)).toEqual(before);
});

describe('requests of foreign pages', () => tryAll(foreign));
describe('foreign host names', () => tryAll(names));
describe('tokens', () => tryAll(tokens));
describe('bodies', () => tryAll(shapes));
describe('bases', () => tryAll(bases));
describe('methods', () => tryAll(methods));
describe('addresses', () => tryAll(ADDRESSES.map((path): Attack => [JSON.stringify(path), 404, () => ({ path })])));

describe.each(IDS.map((id) => [JSON.stringify(id.slice(0, 40)), id]))('the id %s', (_, id) => {
  const expectRefused = async (asked: Asked): Promise<void> => {
    const answer = await server.page.ask(asked);
    expect([400, 404, 409, 412]).toContain(answer.status);
    if (answer.status === 412) expect(answer.json()).toMatchObject({ error: { code: 'conflict', current: null } });
    expect(answer.text).not.toContain('"secret"');
    expect(everythingIn(around.folder)).toEqual(before);
  };
  it('is never read, written or created, however it is encoded', async () => {
    for (const encoded of [encodeURIComponent(id), encodeURIComponent(encodeURIComponent(id))]) {
      const path = `${EDIT_API.LEVEL}?id=${encoded}`;
      await expectRefused({ path });
      await expectRefused({ method: 'PUT', path, body, headers: { 'If-Match': tag } });
    }
    await expectRefused({ method: 'PUT', path: levelPath(id), body, headers: { 'If-None-Match': '*' } });
  });
  it('is refused as the target or the source of a level', async () => {
    const send = (path: string, what: object): Promise<void> =>
      expectRefused({ method: 'POST', path, headers: { 'If-Match': tag }, body: JSON.stringify({ ...what, client }) });
    await send(EDIT_API.RENAME, { id: 'a', to: id });
    await send(EDIT_API.DUPLICATE, { id: 'a', to: id });
    await send(EDIT_API.RENAME, { id, to: 'new' });
    await send(EDIT_API.DUPLICATE, { id, to: 'new' });
    await send(EDIT_API.DELETE, { id });
    await send(EDIT_API.RESTORE, { trash: id });
    await send(EDIT_API.ORDER, { folder: '', ids: [id, 'a', 'broken', 'link'] });
    await send(EDIT_API.ORDER, { folder: id, ids: ['a'] });
  });
});

describe('links', () => {
  it('are listed, but never read, written or moved', async () => {
    const listed = (await server.page.get(EDIT_API.LEVELS)).json() as { levels: { id: string }[] };
    expect(listed.levels.map(({ id }) => id)).toEqual(['a', 'broken', 'link', 'sub/b']);
    const read = (await server.page.get(levelPath('link'))).json();
    expect(read).toMatchObject({
      status: 'unreadable',
      text: null,
      etag: null,
      readOnly: expect.stringContaining('symbolic link'),
    });
    for (const headers of [{ 'If-Match': tag }, { 'If-None-Match': '*' }]) {
      const answer = await server.page.ask({ method: 'PUT', path: levelPath('link'), headers, body });
      expect(answer.status).toBe(412);
      expect(answer.text).not.toContain('"secret"');
    }
    const deleted = await server.page.send('POST', EDIT_API.DELETE, { id: 'link', client }, { 'If-Match': tag });
    expect(deleted.status).toBe(412);
    const moved = await server.page.send('POST', EDIT_API.ORDER, { folder: '', ids: ['link', 'broken', 'a'], client });
    expect(moved).toMatchObject({ status: 403 });
    expect(everythingIn(around.folder)).toEqual(before);
  });
});

/** Sends raw bytes. @returns the status line of the answer, or what happened to the connection */
const raw = (bytes: string): Promise<string> =>
  new Promise((resolve) => {
    const socket = connect(server.port, '127.0.0.1');
    let answer = '';
    socket.on('data', (data) => {
      answer += data.toString('latin1');
    });
    socket.on('error', () => {});
    socket.on('close', () => resolve(answer.split('\r\n')[0]));
    socket.end(bytes);
  });

describe('requests that no HTTP library would send', () => {
  const rest = (): string => `${EDIT_API.TOKEN_HEADER}: ${server.page.token}\r\nConnection: close\r\n`;
  const host = (): string => `Host: 127.0.0.1:${port()}\r\n`;
  it.each([
    ['two hosts', () => `GET /api/levels HTTP/1.1\r\n${host()}Host: evil.example\r\n${rest()}\r\n`],
    ['two hosts, ours last', () => `GET /api/levels HTTP/1.1\r\nHost: evil.example\r\n${host()}${rest()}\r\n`],
    ['no host', () => `GET /api/levels HTTP/1.1\r\n${rest()}\r\n`],
    ['no host, HTTP/1.0', () => `GET /api/levels HTTP/1.0\r\n${rest()}\r\n`],
    ['an address with another host in it', () => `GET http://evil.example/api/levels HTTP/1.1\r\n${host()}${rest()}\r\n`],
    ['an address with our host in it', () => `GET http://127.0.0.1:${port()}/api/levels HTTP/1.1\r\n${host()}${rest()}\r\n`],
    ['a backslash', () => `GET /api\\levels HTTP/1.1\r\n${host()}${rest()}\r\n`],
    ['an asterisk', () => `OPTIONS * HTTP/1.1\r\n${host()}${rest()}\r\n`],
    ['a tunnel', () => `CONNECT evil.example:443 HTTP/1.1\r\n${host()}${rest()}\r\n`],
    ['two lengths', () => `PUT /api/level?id=a HTTP/1.1\r\n${host()}${rest()}Content-Length: 1\r\nContent-Length: 2\r\n\r\nxx`],
    [
      'a length and pieces',
      () => `PUT /api/level?id=a HTTP/1.1\r\n${host()}${rest()}Content-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n`,
    ],
    ['a negative length', () => `PUT /api/level?id=a HTTP/1.1\r\n${host()}${rest()}Content-Length: -1\r\n\r\n`],
    ['a header folded', () => `GET /api/levels HTTP/1.1\r\n${host()}X: a\r\n b\r\n${rest()}\r\n`],
    ['HTTP/2', () => 'PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n'],
    ['TLS', () => '\u0016\u0003\u0001\u0000\u0001'],
  ])('%s', async (_, bytes) => {
    expect(await raw(bytes())).toMatch(/^$|^HTTP\/1\.1 4\d\d /);
    expect(everythingIn(around.folder)).toEqual(before);
  });

  it('a body that is declared too large is not waited for', async () => {
    const head = `PUT ${levelPath('a')} HTTP/1.1\r\n${host()}Origin: http://127.0.0.1:${port()}\r\nContent-Type: application/json\r\nIf-Match: ${tag}\r\n`;
    const socket = connect(server.port, '127.0.0.1');
    const answered = new Promise<string>((resolve) => socket.once('data', (data) => resolve(data.toString('latin1'))));
    socket.write(`${head}${rest()}Content-Length: ${1024 * 1024 + 1}\r\n\r\n{`);
    expect(await answered).toMatch(/^HTTP\/1\.1 413 /);
    socket.destroy();
  });

  it('an incomplete body changes nothing', async () => {
    const head = `PUT ${levelPath('a')} HTTP/1.1\r\n${host()}Origin: http://127.0.0.1:${port()}\r\nContent-Type: application/json\r\nIf-Match: ${tag}\r\n${rest()}`;
    await raw(`${head}Content-Length: ${body.length + 1}\r\n\r\n${body}`);
    await raw(`${head}Transfer-Encoding: chunked\r\n\r\n${body.length.toString(16)}\r\n${body}\r\n`);
    expect(everythingIn(around.folder)).toEqual(before);
    // the same request with the whole body makes the change
    expect(await raw(`${head}Content-Length: ${body.length}\r\n\r\n${body}`)).toBe('HTTP/1.1 200 OK');
    expect(everythingIn(around.folder)).toEqual({ ...before, 'levels/a.level.json': text });
    put(folder, 'a.level.json', levelText('a'));
  });
});
