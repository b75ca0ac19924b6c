import type { Notices } from '../notices/index.ts';

/** Copies a text to the clipboard and reports the result. @param what a name for it: `the link` */
export async function copyText(notices: Notices, what: string, text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    notices.show('info', `Copied ${what}.`, { topic: 'clipboard' });
  } catch {
    notices.show('warning', `The browser does not let this page write to the clipboard: select ${what} and copy it manually.`, {
      topic: 'clipboard',
    });
  }
}
