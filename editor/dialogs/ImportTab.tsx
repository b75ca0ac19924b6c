import { FolderOpen } from 'lucide-react';
import { useId, useState } from 'react';
import { useEditor } from '../context/index.ts';
import { FolderSelect, folderOf } from '../panels/levels/index.ts';
import { chooseFiles } from '../share/index.ts';
import { Button } from '../ui/index.ts';
import { type GivenText, takeIn } from './take-in.ts';

/** Levels from files or text, of this toolkit or of the original game. */
export function ImportTab({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [text, setText] = useState('');
  const [recoil, setRecoil] = useState(true);
  const [folder, setFolder] = useState(() => folderOf(editor.workspace.store.getState().opened?.id() ?? ''));
  const [busy, setBusy] = useState(false);
  const field = useId();
  const take = async (texts: readonly GivenText[]) => {
    setBusy(true);
    const count = await takeIn(editor, folder, texts, recoil);
    setBusy(false);
    if (count > 0) onClose();
  };
  const choose = async () => {
    const files = await chooseFiles();
    if (files !== null) await take(files);
  };
  return (
    <div className="share form">
      <p className="share__about">
        Level files, and lists of levels of the original game. Files can also be dropped anywhere on the page. Every level becomes
        a new one; none is replaced.
      </p>
      <div className="share__buttons">
        <Button
          hint="Choose one or more files"
          look="main"
          icon={<FolderOpen size={15} />}
          disabled={busy}
          onClick={() => void choose()}
        >
          Choose files…
        </Button>
        <label className="share__check">
          <input type="checkbox" checked={recoil} onChange={(event) => setRecoil(event.target.checked)} />
          original levels keep their recoil
        </label>
      </div>
      <FolderSelect value={folder} onChange={setFolder} />
      <label htmlFor={field}>or paste their text</label>
      <textarea
        id={field}
        className="field share__paste"
        rows={8}
        spellCheck={false}
        placeholder='{ "version": 1, "name": … }  or  [{ "player": … }]'
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      <div className="form__buttons">
        <Button
          hint="Add what the text says as new levels"
          look="outlined"
          disabled={busy || text.trim() === ''}
          onClick={() => void take([{ name: 'pasted', text }])}
        >
          Import the text
        </Button>
      </div>
    </div>
  );
}
