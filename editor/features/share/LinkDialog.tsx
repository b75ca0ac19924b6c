import { useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { enteringFolder, formatLevel, type LevelFile, placeIn } from '../../../schema/index.ts';
import { useQuestion } from '../../core/ask/index.ts';
import { type Editor, useEditor, useFolderTerms, usePageTerms, usePageTheme } from '../../core/context/index.ts';
import { levelOf, slugOf } from '../../core/exchange/index.ts';
import { addLevels } from '../../core/levels/index.ts';
import { pictureQuestion, urlOf } from '../../core/pictures/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import { surveyLink } from './survey-link.ts';

/** width of the picture, px */
const WIDTH = 420;

/** Asks before a level from the page's address is added: any website can link here with one. */
export function LinkDialog() {
  const { incoming } = useEditor();
  const file = useStore(incoming);
  const close = () => incoming.setState(null, true);
  return (
    <Dialog
      open={file !== null}
      title="Add the level from the link?"
      about="The level comes from the author of the link. Nothing is stored unless you add it."
      onClose={close}
    >
      {file !== null && <Asked file={file} onClose={close} />}
    </Dialog>
  );
}

/** A picture and the verdict of the level, made by a worker so that a costly level does not block the page. */
function usePicture(text: string): { readonly url: string | null; readonly words: string } {
  const { desk } = useEditor();
  const theme = usePageTheme();
  const { folder } = usePageTerms();
  // Rules of a folder do not apply to a level from a link.
  const drawing = useMemo(() => ({ text, terms: { ...folder, rules: {} }, width: WIDTH, theme }), [text, folder, theme]);
  const { phase, answer } = useQuestion(pictureQuestion, desk, drawing) ?? { phase: 'idle', answer: null };
  const [url, setUrl] = useState<string | null>(null);
  useEffect(() => {
    if (answer === null) return;
    const made = urlOf(answer.svg);
    setUrl(made);
    return () => {
      setUrl(null);
      if (made !== null) URL.revokeObjectURL(made);
    };
  }, [answer]);
  if (answer !== null) return { url, words: answer.verdict };
  return { url: null, words: phase === 'failed' ? 'unknown: it takes too long to simulate' : 'checking…' };
}

function Asked({ file, onClose }: { readonly file: LevelFile; readonly onClose: () => void }) {
  const editor = useEditor();
  const text = useMemo(() => formatLevel(file), [file]);
  const { counts, size, warnings } = useMemo(() => surveyLink(file, text), [file, text]);
  const { url, words } = usePicture(text);
  const folder = useFolderTerms();
  const [busy, setBusy] = useState(false);
  const add = async () => {
    setBusy(true);
    const kept = enteringFolder(file, folder.rules);
    const added = await addLevels(editor, '', [{ stem: slugOf(file.name), file: kept }]);
    setBusy(false);
    if (added.length === 0) return;
    onClose();
    const ruled = kept === file ? '' : ` It keeps its own rules instead of those of ${folder.file}.`;
    editor.notices.show('info', `"${file.name}" was added from the link.${ruled}`, { topic: 'link' });
  };
  return (
    <div className="form link">
      <p className="link__name">{file.name}</p>
      {file.description !== undefined && <p className="link__text">{file.description}</p>}
      {url !== null && <img className="link__picture" src={url} alt="" />}
      <dl className="link__facts">
        <dt>Contents</dt>
        <dd>{counts}</dd>
        <dt>Size</dt>
        <dd>{size}</dd>
        <dt>Verdict</dt>
        <dd>{words}</dd>
      </dl>
      {warnings.length > 0 && (
        <ul className="link__warnings" aria-label="Warnings">
          {warnings.map((warning) => (
            <li key={warning}>{warning}</li>
          ))}
        </ul>
      )}
      <div className="form__buttons">
        <Button hint="Close without adding the level" look="outlined" onClick={onClose}>
          Don't add
        </Button>
        <Button hint="Add it as a new level and open it" look="main" disabled={busy} onClick={() => void add()}>
          Add level
        </Button>
      </div>
    </div>
  );
}

/** Takes the level out of the page's address and asks the user whether to add it; a reload does not ask again. */
async function takeLink({ notices, incoming }: Editor): Promise<void> {
  const { hash } = window.location;
  if (placeIn(hash) !== null) return;
  const linked = await levelOf(hash);
  if (linked === null) return;
  // a play beside the level is taken by itself
  if (hash.startsWith(window.location.hash) && window.location.hash !== '') {
    // A full URL: a path that begins with two slashes would otherwise name another host.
    const bare = new URL(window.location.href);
    bare.hash = '';
    window.history.replaceState(window.history.state, '', bare.href.replace(/#$/, ''));
  }
  if (linked.ok) incoming.setState(linked.file, true);
  else notices.show('error', linked.message, { topic: 'link' });
}

/**
 * Handles links once the list of levels is known: the link that opened the page, and links typed into its address. @returns
 * stops it
 */
export function followLinks(editor: Editor): () => void {
  const { store } = editor.workspace;
  const take = () => void takeLink(editor);
  let stop = () => {};
  const start = () => {
    stop();
    take();
    window.addEventListener('hashchange', take);
    stop = () => window.removeEventListener('hashchange', take);
  };
  if (store.getState().list !== null) start();
  else {
    stop = store.subscribe(({ list }) => {
      if (list !== null) start();
    });
  }
  return () => stop();
}
