import { createHmac, randomBytes } from 'node:crypto';
import { runMessage, tokenMessage } from '../../schema/index.ts';

/** What lets pages in. */
export interface Access {
  /** The key of the folder: who has it can derive the token of any run. */
  readonly key: string;
  /** What each request of this run must have. */
  readonly token: string;
  /** Tells a page that has the key which run this is, and that this server has the key, too. */
  run(port: number, challenge: string): { readonly nonce: string; readonly proof: string };
}

/**
 * The access to one run. A page never sends the key, and sends its token to nobody who has not proved to have the key. So a program
 * that listens on the port once `gq edit` has ended learns from the page at most the token of a run that is over.
 */
export function createAccess(key: string): Access {
  const nonce = randomBytes(16).toString('base64url');
  const sign = (message: string): string => createHmac('sha256', key).update(message).digest('base64url');
  return {
    key,
    token: sign(tokenMessage(nonce)),
    run: (port, challenge) => ({ nonce, proof: sign(runMessage(port, challenge, nonce)) }),
  };
}

export const newKey = (): string => randomBytes(32).toString('base64url');
