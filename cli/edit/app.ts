import type { HttpBindings } from '@hono/node-server';
import { Hono } from 'hono';
import type { ContentfulStatusCode } from 'hono/utils/http-status';
import { EDIT_API } from '../../schema/index.ts';
import type { Answer, EditContext } from './api.ts';
import { checkToken, guard } from './guard.ts';
import { SECURITY_HEADERS } from './headers.ts';
import type { PageFile } from './page-files.ts';
import { bodyOf, Refusal, statusOf } from './refusal.ts';

export interface AppOptions {
  readonly api: ReadonlyMap<string, Answer>;
  readonly page: ReadonlyMap<string, PageFile>;
  readonly token: string;
  /** The port that the server listens on, once it does. */
  readonly port: () => number;
  /** Called with errors that are bugs of gq, not mistakes of the user. */
  readonly onCrash: (error: unknown) => void;
}

/** The page and the API in one app. */
export function createApp({ api, page, token, port, onCrash }: AppOptions): Hono<{ Bindings: HttpBindings }> {
  const answer = (c: EditContext): Response | Promise<Response> => {
    const { incoming } = c.env;
    guard(incoming, port());
    const { method = '', url = '' } = incoming;
    // the raw URL: nothing is decoded or resolved, so no encoding can disguise an address
    const question = url.indexOf('?');
    const address = question < 0 ? url : url.slice(0, question);
    const file = page.get(address);
    if (file !== undefined) {
      if (method !== 'GET' && method !== 'HEAD') throw wrongMethod('GET, HEAD', method);
      return answerPage(c, file);
    }
    const found = api.get(`${method} ${address}`);
    if (found === undefined) throw noAnswer(api, method, address);
    // a page that has only the key asks for this first
    if (address !== EDIT_API.RUN) checkToken(incoming, token);
    return found(c, new URLSearchParams(question < 0 ? '' : url.slice(question + 1)));
  };

  const app = new Hono<{ Bindings: HttpBindings }>();
  app.use(async (c, next) => {
    await next();
    for (const [name, value] of Object.entries(SECURITY_HEADERS)) c.res.headers.set(name, value);
    if (!c.res.headers.has('Cache-Control')) c.res.headers.set('Cache-Control', 'no-store');
  });
  app.all('*', answer);
  app.onError((error, c) => {
    if (!(error instanceof Refusal)) onCrash(error);
    const refusal =
      error instanceof Refusal
        ? error
        : new Refusal('failed', 'gq edit failed on this request', 'This is a bug in gq: please report it.');
    // the rest of a refused body is not read
    if (refusal.code === 'body-too-large') c.header('Connection', 'close');
    return c.json(bodyOf(refusal), statusOf(refusal) as ContentfulStatusCode);
  });
  return app;
}

function answerPage(c: EditContext, file: PageFile): Response {
  const caching = { ETag: file.etag, 'Cache-Control': file.isForever ? 'private, max-age=31536000, immutable' : 'no-cache' };
  if (c.env.incoming.headers['if-none-match'] === file.etag) return c.body(null, 304, caching);
  return c.body(file.content, 200, { 'Content-Type': file.type, ...caching });
}

function noAnswer(api: ReadonlyMap<string, Answer>, method: string, address: string): Refusal {
  const methods = [...api.keys()].map((key) => key.split(' ')).filter(([, known]) => known === address);
  if (methods.length > 0) return wrongMethod(methods.map(([known]) => known).join(', '), method);
  return new Refusal('unknown-address', 'there is nothing at this address', 'Open the address that gq edit printed.');
}

const wrongMethod = (expected: string, found: string): Refusal =>
  new Refusal('wrong-method', `expected ${expected}, found ${found}`, 'Reload the page: it may come from another version of gq.');
