import { spawn } from 'node:child_process';
import process from 'node:process';
import { systemReason } from '../io/index.ts';

/** The command that opens an address in the user's default browser; no shell interprets it. */
function opener(address: string): [command: string, args: string[]] {
  if (process.platform === 'darwin') return ['open', [address]];
  if (process.platform === 'win32') return ['rundll32', ['url.dll,FileProtocolHandler', address]];
  return ['xdg-open', [address]];
}

/**
 * Opens an address in the browser.
 * @param onFailure called with the reason if it can't be opened
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
