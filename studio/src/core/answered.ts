// Response of the engine with its messages.

import type { Answer } from "./engine";
import type { Message } from "./message";

export interface Answered extends Answer {
  messages: Message[];
}
