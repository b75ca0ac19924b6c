/** The address of a published page, or why a text is none. */
export type PlayPage = { readonly ok: true; readonly address: string } | { readonly ok: false; readonly message: string };

/** Reads the address of a published page as a person types or pastes it: without a fragment, and with `https://` if that is missing. */
export function playPageOf(typed: string): PlayPage {
  const text = typed.trim();
  const isLocal = /^(?:localhost|127\.0\.0\.1)(?::|\/|$)/i.test(text);
  const full = isLocal ? `http://${text}` : /^[a-z][a-z\d+.-]*:/i.test(text) ? text : `https://${text}`;
  if (!URL.canParse(full))
    return { ok: false, message: 'expected the address of the page, such as https://me.github.io/levels/' };
  const url = new URL(full);
  if (!['https:', 'http:', 'file:'].includes(url.protocol))
    return { ok: false, message: `expected an address that begins with https://, found ${url.protocol}` };
  url.hash = '';
  return { ok: true, address: url.href.replace(/#$/, '') };
}
