export { fetched, laterCover, laterDialog, laterOnce, laterPanel, laterPart, loadParts } from './later.tsx';
export { FolderSelect, Offer, PlayButton, SamplesButton, TextDialog } from './offers.tsx';
export { Facts, OutcomeSign, outcomeWord, Progress, Section, Segments, Trouble } from './parts.tsx';
