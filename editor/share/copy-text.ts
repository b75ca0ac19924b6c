import type { Notices } from '../notices/index.ts';

/** Puts a text on the clipboard, and says whether that went well. @param what for people: `the link` */
export async function copyText(notices: Notices, what: string, text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    notices.show('info', `Copied ${what}.`, { topic: 'clipboard' });
  } catch {
    notices.show('warning', `The browser does not let this page write to the clipboard: mark ${what} and copy it by hand.`, {
      topic: 'clipboard',
    });
  }
}
