import { Copy } from 'lucide-react';
import { useEffect, useMemo, useState } from 'react';
import { useDocument, useEditor, useFolderRules } from '../context/index.ts';
import { copyText, type Linking, leavingFolder, linkTo } from '../share/index.ts';
import { Button } from '../ui/index.ts';

/** A link that contains the open level. */
export function LinkTab() {
  const { notices, workspace } = useEditor();
  const open = useDocument((state) => state.file);
  const rules = useFolderRules();
  const file = useMemo(() => leavingFolder(open, rules.own), [open, rules.own]);
  const [withRuns, setWithRuns] = useState(true);
  const [linking, setLinking] = useState<Linking | null>(null);
  useEffect(() => {
    let isGone = false;
    const { runs: _, ...bare } = file;
    void linkTo(withRuns ? file : bare, `${location.origin}${location.pathname}`).then((made) => {
      if (!isGone) setLinking(made);
    });
    return () => {
      isGone = true;
    };
  }, [file, withRuns]);
  return (
    <div className="share">
      <p className="share__about">
        Anyone who opens this link gets a copy of the level as it is now. The link itself contains the level, compressed.
        {workspace.storage.kind === 'server' && ' This editor runs on your machine only, so the link works only for you.'}
        {file !== open && ` The link includes the rules of ${rules.file}, so that the level plays the same without that file.`}
      </p>
      <label className="share__check">
        <input type="checkbox" checked={withRuns} onChange={(event) => setWithRuns(event.target.checked)} />
        include the runs, which give the solution away
      </label>
      {linking?.ok === true && (
        <>
          <textarea
            className="field share__link"
            aria-label="Link with the level"
            readOnly
            rows={4}
            value={linking.url}
            onFocus={(event) => event.target.select()}
          />
          <div className="share__buttons">
            <Button
              hint="Copy the link"
              look="main"
              icon={<Copy size={15} />}
              onClick={() => void copyText(notices, 'the link', linking.url)}
            >
              Copy the link
            </Button>
            <span className="share__about numbers">{linking.url.length} characters</span>
          </div>
        </>
      )}
      {linking?.ok === false && (
        <p role="alert">
          {linking.message}. {linking.hint}.
        </p>
      )}
    </div>
  );
}
