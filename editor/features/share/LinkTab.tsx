import { Copy } from 'lucide-react';
import { useEffect, useId, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { leavingFolder } from '../../../schema/index.ts';
import { useDocument, useEditor, useFolderTerms } from '../../core/context/index.ts';
import { copyText, type Linking, linkTo, playPageOf } from '../../core/exchange/index.ts';
import { Button } from '../../core/ui/index.ts';

/** A link that contains the open level: for this editor, or for a page on which it can only be played. */
export function LinkTab() {
  const { notices, workspace, session, settings } = useEditor();
  const open = useDocument((state) => state.file);
  const folder = useFolderTerms();
  const terms = useStore(useEditor().terms, (state) => state.folder);
  const field = useId();
  const typed = useStore(settings, (state) => state.playPage);
  const file = useMemo(() => leavingFolder(open, folder.rules), [open, folder.rules]);
  const [withRuns, setWithRuns] = useState(true);
  const [isPlayOnly, setPlayOnly] = useState(false);
  const [linking, setLinking] = useState<Linking | null>(null);
  const page = useMemo(() => (typed.trim() === '' ? null : playPageOf(typed)), [typed]);
  const here = `${location.origin}${location.pathname}`;
  const address = isPlayOnly ? (page?.ok ? page.address : null) : here;
  useEffect(() => {
    let isGone = false;
    setLinking(null);
    const { runs: _, ...bare } = file;
    if (address !== null)
      void linkTo(withRuns ? file : bare, terms, address).then((made) => {
        if (!isGone) setLinking(made);
      });
    return () => {
      isGone = true;
    };
  }, [file, terms, withRuns, address]);
  return (
    <div className="share">
      <fieldset className="publish__targets">
        <legend className="unseen">What the link opens</legend>
        <label className="share__check">
          <input type="radio" name={`${field}-page`} checked={!isPlayOnly} onChange={() => setPlayOnly(false)} />
          opens in this editor
        </label>
        <label className="share__check">
          <input type="radio" name={`${field}-page`} checked={isPlayOnly} onChange={() => setPlayOnly(true)} />
          play only: opens in the game, on a page that you have published
        </label>
      </fieldset>
      {isPlayOnly && (
        <>
          <div className="publish__fields">
            <label htmlFor={`${field}-address`}>Address of the page</label>
            <input
              id={`${field}-address`}
              className="field"
              type="text"
              inputMode="url"
              spellCheck={false}
              placeholder="https://me.github.io/levels/"
              value={typed}
              aria-invalid={page?.ok === false}
              onChange={(event) => settings.setState({ playPage: event.target.value })}
            />
          </div>
          {page === null && (
            <div className="share__buttons">
              <p className="share__about">
                The link needs a page that is on the web: publish one, put it on a web server, and enter its address here. Any
                published page plays any level.
              </p>
              <Button
                hint="Make a page on which levels are played"
                look="outlined"
                onClick={() => session.setState({ overlay: 'publish' })}
              >
                Publish a page
              </Button>
            </div>
          )}
          {page?.ok === false && <p role="alert">Address of the page: {page.message}.</p>}
        </>
      )}
      <p className="share__about">
        {isPlayOnly
          ? 'Anyone who opens this link plays the level as it is now, and can’t edit it. '
          : 'Anyone who opens this link gets a copy of the level as it is now. '}
        The link itself contains the level, compressed.
        {!isPlayOnly &&
          workspace.storage.kind === 'server' &&
          ' This editor runs on your machine only, so the link works only for you.'}
        {file !== open && ` The link includes the rules of ${folder.file}, so that the level plays the same without that file.`}
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
