import { realpathSync } from 'node:fs';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { dirname } from 'node:path';
import { createAdaptorServer } from '@hono/node-server';
import type { ConfigOptions } from '../config/index.ts';
import { siblingHint, statOrError } from '../io/index.ts';
import { Failure, namedPath, shellPath, systemReason } from '../terminal/index.ts';
import { createAccess, keepPort, keptKey, lastPort } from './access.ts';
import { createApi } from './api.ts';
import { createApp, readPage } from './app.ts';
import { openLevelFolder } from './level-folder.ts';
import { createPublish } from './publish.ts';
import { termsOnDisk } from './terms-on-disk.ts';
import { watchConfig, watchFolder } from './watch.ts';

/** A browser keeps unsaved work under the page's address, which includes the port. So a folder keeps the port that it had. */
export const DEFAULT_PORT = 4747;

/** The number of ports to try if the user asked for none. */
const TRIED = 20;

export interface EditServer {
  readonly port: number;
  /** The folder's last port; null if it is not known. */
  readonly portBefore: number | null;
  /** Contains the token of this run. */
  readonly address: string;
  /** Why the pages of this run can't come back in the next one; null: they can. */
  readonly keyProblem: string | null;
  /** Closes all connections and stops the server. */
  close(): Promise<void>;
}

export interface EditServerOptions {
  /** The folder as the user named it. */
  readonly folder: string;
  /** 0 and null: the last port, if it is free; else 0 is any port, and null the first free one from `DEFAULT_PORT` on. */
  readonly port: number | null;
  /** The search for `gq.config.json` starts in this folder and goes upwards. */
  readonly configFrom: string;
  /** A file to read instead, or false for none. */
  readonly config?: ConfigOptions['config'];
  /** The folder that contains the built page. */
  readonly page: string;
  /** The folder that contains the built game. */
  readonly game: string;
  readonly onCrash: (error: unknown) => void;
}

/**
 * Starts the editor's server on 127.0.0.1.
 * @throws Failure when the folder or the page is not what it should be, or the port is taken
 */
export async function startServer({
  folder,
  port,
  configFrom,
  config,
  page,
  game,
  onCrash,
}: EditServerOptions): Promise<EditServer> {
  const root = realFolder(folder);
  const files = readPage(page);
  const levels = openLevelFolder(root, folder, termsOnDisk(configFrom, config));
  const { id } = levels.known.list().folder;
  // `--port 0` has a memory of its own: it reuses the last port that was chosen for `--port 0`
  const memory = port === 0 ? `${id}-any` : id;
  const { key, problem } = keptKey(id);
  const access = createAccess(key);
  const portNow = (): number => (server.address() as AddressInfo).port;
  const app = createApp({
    api: createApi(levels, createPublish({ root, shown: folder, configFrom, config, game }), access, portNow),
    page: files,
    token: access.token,
    port: portNow,
    onCrash,
  });
  const server = createAdaptorServer({
    fetch: app.fetch,
    overrideGlobalObjects: false,
    serverOptions: { maxHeaderSize: 16 * 1024 },
  }) as Server;
  // a client must not hold a connection open without sending a request
  server.headersTimeout = 10_000;
  server.requestTimeout = 60_000;
  const before = lastPort(memory);
  await listen(server, port, before);
  const watches = [watchFolder(root, levels.known), watchConfig(configFrom, levels.known, config)];
  const listening = portNow();
  const close = async (): Promise<void> => {
    for (const end of watches) end();
    levels.end();
    server.closeAllConnections();
    await new Promise((resolve) => server.close(resolve));
  };
  // without `--port`, the known last port stays remembered even if it is taken now: the browser may keep unsaved work under it
  if (before === null || port !== null) keepPort(memory, listening);
  return {
    port: listening,
    portBefore: before,
    address: `http://127.0.0.1:${listening}/#token=${access.token}`,
    keyProblem: problem,
    close,
  };
}

function realFolder(folder: string): string {
  const stats = statOrError(folder);
  if (stats instanceof Error) {
    const near = siblingHint(folder);
    // a folder can't be made in the place of a link
    const make = near.startsWith(';') ? '' : `; make one with: mkdir ${shellPath(folder)}`;
    throw new Failure(
      `${namedPath(folder)}: can't be opened: ${systemReason(stats)}${near}; expected a folder of level files${make}`,
    );
  }
  if (!stats.isDirectory()) {
    throw new Failure(`${folder}: is a file; expected a folder of level files: gq edit ${shellPath(dirname(folder))}`);
  }
  return realpathSync(folder);
}

async function listen(server: Server, port: number | null, before: number | null): Promise<void> {
  if (port !== null && port !== 0) return listenOn(server, port);
  const usual = port === 0 ? [] : Array.from({ length: TRIED }, (_, i) => DEFAULT_PORT + i);
  for (const tried of before === null ? usual : [before, ...usual]) {
    try {
      return await listenOn(server, tried);
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
    }
  }
  return listenOn(server, 0);
}

function listenOn(server: Server, port: number): Promise<void> {
  return new Promise((resolve, reject) => {
    const onError = (error: NodeJS.ErrnoException): void => {
      const why = error.code === 'EADDRINUSE' ? 'the port is in use, perhaps by another gq edit' : systemReason(error);
      reject(
        new Failure(`--port ${port}: can't listen on it: ${why}; give another port, or leave the option out to take a free one`),
      );
    };
    server.once('error', onError);
    server.listen({ port, host: '127.0.0.1', exclusive: true }, () => {
      server.off('error', onError);
      resolve();
    });
  });
}
