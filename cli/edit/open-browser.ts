import { spawn } from 'node:child_process';
import process from 'node:process';
import { systemReason } from '../failure.ts';

/** What opens an address in the browser a person has chosen; no shell reads it. */
function opener(address: string): [command: string, args: string[]] {
  if (process.platform === 'darwin') return ['open', [address]];
  if (process.platform === 'win32') return ['rundll32', ['url.dll,FileProtocolHandler', address]];
  return ['xdg-open', [address]];
}

/**
 * Opens an address in the browser.
 * @param onFailure called with why it could not be opened
 */
export function openBrowser(address: string, onFailure: (why: string) => void): void {
  const [command, args] = opener(address);
  const child = spawn(command, args, { stdio: 'ignore', detached: true });
  child.on('error', (error) => onFailure(`${command}: ${systemReason(error)}`));
  child.on('exit', (code) => {
    if (code !== null && code !== 0) onFailure(`${command} ended with ${code}`);
  });
  child.unref();
}
