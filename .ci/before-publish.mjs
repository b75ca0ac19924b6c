// Refuses to publish the package without the address of its repository, since npm resolves the links and pictures of README.md by
// it, and with results that its version does not allow.
import { readFileSync } from 'node:fs';
import process from 'node:process';
import { problemsHere } from './check-version.mjs';

/**
 * @param {{ readonly repository?: string | { readonly type?: string, readonly url?: string } }} manifest
 * @returns {string | null} why the package must not be published yet; null if it may be
 */
export function reasonAgainst({ repository }) {
  const url = typeof repository === 'string' ? repository : repository?.url;
  if (typeof url === 'string' && url !== '') return null;
  return 'package.json has no "repository": set it to the address of the repository, as CONTRIBUTING.md says';
}

if (process.argv[1] === import.meta.filename) {
  const reason = reasonAgainst(JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8')));
  const reasons = [...(reason === null ? [] : [reason]), ...(await problemsHere())];
  for (const each of reasons) console.error(`not published: ${each}`);
  if (reasons.length > 0) process.exitCode = 1;
}
