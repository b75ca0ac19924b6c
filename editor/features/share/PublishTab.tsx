import { FileCode2, FolderOutput } from 'lucide-react';
import { useId, useState } from 'react';
import { useStore } from 'zustand';
import { LEVEL_ID_PART, type RefusedLevel } from '../../../schema/index.ts';
import { useEditor } from '../../core/context/index.ts';
import { folderPackIn } from '../../core/files/index.ts';
import { VerdictSign } from '../../core/levels/index.ts';
import { Button } from '../../core/ui/index.ts';
import { type Published, publish, type Target } from './publish.ts';

/** characters */
const LONGEST_TITLE = 200;

const TARGETS: Readonly<Record<Target, { readonly title: string; readonly about: string }>> = {
  folder: { title: 'All levels, as a folder', about: 'beside the folder of the levels, for any web server or none' },
  levelFolder: { title: 'This level alone, as a folder', about: 'beside the folder of the levels' },
  file: {
    title: 'All levels, as one HTML file',
    about: 'a download that needs nothing else: open it, send it, or put it on any web server',
  },
  levelFile: {
    title: 'This level alone, as one HTML file',
    about: 'a download that needs nothing else: open it, send it, or host it',
  },
};

/** Whether a person may decide to publish a level all the same. */
const isChoice = ({ verdict }: RefusedLevel): boolean => verdict !== 'invalid' && verdict !== 'crashed';

/** Makes a page on which levels can be played, but not edited. */
export function PublishTab() {
  const editor = useEditor();
  const { workspace } = editor;
  const field = useId();
  const list = useStore(workspace.store, (state) => state.list);
  const level = useStore(editor.open);
  const hasFolders = workspace.storage.publish !== null;
  const targets: readonly Target[] = hasFolders ? ['folder', 'levelFolder', 'levelFile'] : ['file', 'levelFile'];
  const [target, setTarget] = useState<Target>(targets[0]);
  const [site, setSite] = useState('site');
  const [typed, setTyped] = useState<string | null>(null);
  const [withRuns, setWithRuns] = useState(true);
  const [progress, setProgress] = useState<string | null>(null);
  const [published, setPublished] = useState<Published | null>(null);
  const refused = published?.kind === 'refused' ? published.levels : [];
  const isAlone = target === 'levelFolder' || target === 'levelFile';
  const isFolder = target === 'folder' || target === 'levelFolder';
  const name = useStore(workspace.store, ({ list: known, opened }) => known?.levels.find(({ id }) => id === opened?.id())?.name);
  const pack = useStore(workspace.store, folderPackIn);
  const game = pack.kind === 'valid' ? pack.reading.pack.name : 'Gravity Quest';
  const title = typed ?? (isAlone ? (name ?? 'Gravity Quest') : game);
  const count = list?.levels.length ?? 0;
  const badSite = isFolder && !LEVEL_ID_PART.test(site);
  const isReady = progress === null && title.trim() !== '' && !badSite && (isAlone ? level !== null : count > 0);

  const change =
    <T,>(set: (value: T) => void) =>
    (value: T) => {
      setPublished(null);
      set(value);
    };
  const start = async (force: boolean) => {
    setPublished(null);
    setProgress('Checking the levels …');
    const onProgress = (checked: number, all: number) => setProgress(`Checking the levels: ${checked} of ${all} …`);
    setPublished(await publish(editor, { target, site, title: title.trim(), withRuns, force, onProgress }));
    setProgress(null);
  };

  return (
    <form
      className="share"
      onSubmit={(event) => {
        event.preventDefault();
        if (isReady) void start(false);
      }}
    >
      <p className="share__about">
        A page on which levels are played one after the other. It works from any web server, and from a file without one.
      </p>
      <fieldset className="publish__targets">
        <legend className="unseen">What to publish</legend>
        {targets.map((one) => (
          <label key={one} className="publish__target">
            <input
              type="radio"
              name={`${field}-target`}
              checked={one === target}
              disabled={(one === 'levelFile' || one === 'levelFolder') && level === null}
              onChange={() => change(setTarget)(one)}
            />
            <span>
              {TARGETS[one].title}
              <small>{TARGETS[one].about}</small>
            </span>
          </label>
        ))}
      </fieldset>
      <div className="publish__fields">
        <label htmlFor={`${field}-title`}>Title</label>
        <input
          id={`${field}-title`}
          className="field"
          value={title}
          maxLength={LONGEST_TITLE}
          onChange={(event) => change(setTyped)(event.target.value)}
        />
        {isFolder && (
          <>
            <label htmlFor={`${field}-site`}>Folder</label>
            <input
              id={`${field}-site`}
              className="field"
              value={site}
              aria-invalid={badSite}
              aria-describedby={badSite ? `${field}-bad` : undefined}
              onChange={(event) => change(setSite)(event.target.value)}
            />
          </>
        )}
      </div>
      {badSite && (
        <p id={`${field}-bad`} role="alert">
          The folder needs a name of letters a-z, digits, spaces, _ and -.
        </p>
      )}
      <label className="share__check">
        <input type="checkbox" checked={withRuns} onChange={(event) => change(setWithRuns)(event.target.checked)} />
        include the runs as ghosts, which give the solutions away
      </label>
      {refused.length > 0 && (
        <div role="alert" className="publish__refused">
          <p>
            {refused.length === 1 ? 'A level is' : `${refused.length} levels are`} not known to be completable, so nothing was
            published:
          </p>
          <ul className="share__refusals">
            {refused.map((one) => (
              <li key={one.id}>
                <VerdictSign verdict={one.verdict === 'crashed' ? 'invalid' : one.verdict} /> {one.name} ({one.id}): {one.message}
              </li>
            ))}
          </ul>
          {!refused.every(isChoice) && <p>Nobody can play a level that is not valid: fix it, or move it out of the folder.</p>}
        </div>
      )}
      {published?.kind === 'failed' && (
        <div role="alert" className="publish__refused">
          <p className="publish__why">{published.message}</p>
          {published.reasons.length > 0 && (
            <ul className="share__refusals">
              {published.reasons.map((reason) => (
                <li key={reason}>{reason}</li>
              ))}
            </ul>
          )}
        </div>
      )}
      {published?.kind === 'done' && <p role="status">{published.message}</p>}
      <div className="share__buttons">
        <Button
          type="submit"
          hint="Check the levels, then make the page"
          look="main"
          icon={isFolder ? <FolderOutput size={15} /> : <FileCode2 size={15} />}
          disabled={!isReady}
        >
          Publish
        </Button>
        {refused.length > 0 && refused.every(isChoice) && (
          <Button hint="Players may meet a level that nobody can complete" look="danger" onClick={() => void start(true)}>
            Publish all the same
          </Button>
        )}
        {progress !== null && (
          <span className="share__about" role="status">
            {progress}
          </span>
        )}
      </div>
    </form>
  );
}
