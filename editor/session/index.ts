export {
  createSession,
  LAYERS,
  type Layer,
  RATES,
  type Replay,
  type Session,
  type SessionStore,
  TOOLS,
  type Tool,
} from './session.ts';
