import { CircleAlert, FolderOpen } from 'lucide-react';
import { useEffect, useId, useState } from 'react';
import { useEditor } from '../../core/context/index.ts';
import { chooseFiles } from '../../core/exchange/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { FolderSelect } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { IMPORT_TOPIC, type ImportResult, importContents, importFiles } from './import-files.ts';

/** Imports levels of this toolkit or of the original game from files or text. */
export function ImportTab({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [text, setText] = useState('');
  const [recoil, setRecoil] = useState(true);
  const [folder, setFolder] = useState(() => folderOf(editor.workspace.store.getState().opened?.id() ?? ''));
  const [busy, setBusy] = useState(false);
  const field = useId();
  const [refusals, setRefusals] = useState<readonly string[]>([]);
  const take = async (act: () => Promise<ImportResult>) => {
    setBusy(true);
    setRefusals([]);
    const { added, refusals: refused } = await act();
    setBusy(false);
    setRefusals(refused);
    if (added > 0 && refused.length === 0) onClose();
  };
  const choose = async () => {
    const files = await chooseFiles();
    if (files !== null) await take(() => importFiles(editor, folder, files, recoil));
  };
  // A notice about refused dropped files is outdated now.
  useEffect(() => editor.notices.clear(IMPORT_TOPIC), [editor]);
  return (
    <div className="share form">
      <p className="share__about">
        Import level files or level lists of the original game. You can also drop files anywhere on the page. Every level is added
        as a new level; none is replaced.
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
          keep the recoil of original levels
        </label>
      </div>
      <FolderSelect value={folder} onChange={setFolder} />
      <label htmlFor={field}>Or paste their text</label>
      <textarea
        id={field}
        className="field share__paste"
        rows={8}
        spellCheck={false}
        placeholder='{ "version": 1, "name": … }  or  [{ "player": … }]'
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      {refusals.length > 0 && (
        <ul className="share__refusals" role="alert" aria-label="Not imported">
          {refusals.map((refusal) => (
            <li key={refusal}>
              <CircleAlert size={14} aria-hidden /> {refusal}
            </li>
          ))}
        </ul>
      )}
      <div className="form__buttons">
        <Button
          hint="Add the levels in the text as new levels"
          look="outlined"
          disabled={busy || text.trim() === ''}
          onClick={() => void take(() => importContents(editor, folder, [{ name: 'pasted text', content: text }], recoil))}
        >
          Import text
        </Button>
      </div>
    </div>
  );
}
