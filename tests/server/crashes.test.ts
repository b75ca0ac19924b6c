import { describe, expect, it } from 'vitest';
import { type AppOptions, createApp, guard } from '../../cli/serve/app.ts';
import { Refusal } from '../../cli/serve/refusal.ts';

/** An incoming request as Node represents it. */
const incoming = (headers: Record<string, string>, method = 'GET', url = '/api/levels') => ({
  ...{ method, url, headers },
  rawHeaders: Object.entries(headers).flat(),
  headersDistinct: Object.fromEntries(Object.entries(headers).map(([name, value]) => [name, [value]])),
});

describe('an error that is a bug of gq', () => {
  it('is passed to onCrash, and reported to the page without any details', async () => {
    const crashes: unknown[] = [];
    const errors = [new Error('secret'), new Refusal('busy', 'busy now', 'Wait.'), new TypeError('other')];
    const options: AppOptions = {
      api: new Map([
        [
          'GET /api/levels',
          () => {
            throw errors.shift();
          },
        ],
      ]),
      page: new Map(),
      token: 'token',
      port: () => 4747,
      onCrash: (error) => crashes.push(error),
    };
    const app = createApp(options);
    const ask = async () => {
      const env = { incoming: incoming({ host: '127.0.0.1:4747', 'x-gq-token': 'token' }) };
      const answer = await app.request('/api/levels', {}, env as never);
      return [answer.status, ((await answer.json()) as { error: object }).error];
    };
    const failed = { code: 'failed', message: 'gq edit failed on this request', hint: 'This is a bug in gq: please report it.' };
    expect(await ask()).toEqual([500, failed]);
    expect(await ask()).toEqual([503, { code: 'busy', message: 'busy now', hint: 'Wait.' }]);
    expect(await ask()).toEqual([500, failed]);
    expect(crashes).toEqual([new Error('secret'), new TypeError('other')]);
  });
});

it('an upgrade is refused, however it is requested', () => {
  const asked = (headers: Record<string, string>) => {
    try {
      guard(incoming({ host: '127.0.0.1:4747', ...headers }) as never, 4747);
      return null;
    } catch (error) {
      return (error as Refusal).code;
    }
  };
  expect(asked({ connection: 'keep-alive' })).toBeNull();
  for (const headers of [{ upgrade: 'websocket' }, { connection: 'Upgrade' }, { connection: 'keep-alive, upgrade' }] as const)
    expect(asked(headers as unknown as Record<string, string>)).toBe('upgrade-refused');
});

describe('the host of a request', () => {
  const passes = (host: string, port: number) => {
    try {
      guard(incoming({ host }) as never, port);
      return true;
    } catch {
      return false;
    }
  };
  it('contains the port of the server, which a browser omits if it is 80', () => {
    const hosts = [
      '127.0.0.1',
      'localhost',
      '127.0.0.1:80',
      'localhost:80',
      '127.0.0.1:4747',
      'localhost:4747',
      '127.0.0.1:81',
      '',
    ];
    expect(hosts.filter((host) => passes(host, 4747))).toEqual(['127.0.0.1:4747', 'localhost:4747']);
    expect(hosts.filter((host) => passes(host, 80))).toEqual(['127.0.0.1', 'localhost', '127.0.0.1:80', 'localhost:80']);
  });
});
